//! What can compute here, and which of it is taken.

use std::cmp::Reverse;
use std::fmt;

use crate::error::GpuError;
use crate::limits::{AdapterLimits, Lack};

/// Nodes from which a hardware GPU is taken where nothing else is asked for.
///
/// An estimate until figures of hardware are taken (`./on-a-gpu` takes them): the processor needs some 54 ns for a node and step (`BENCHMARKS.md`),
/// half a millisecond for a step of this size. A step on a GPU is three dispatches of dynamics or five of a relaxation, which
/// cost as much to start on a small sheet as on a large one.
pub const AUTO_NODES: usize = 10_000;

/// Whether [`AUTO_NODES`] is what measurements came to, and not an estimate. Reports and help say so where it is not.
pub const AUTO_NODES_MEASURED: bool = false;

/// The environment variable that names an adapter.
const VARIABLE: &str = "ORIGAMI_ADAPTER";

/// Names under which programs that compute on the processor pass for GPUs of unknown kind.
const SOFTWARE: [&str; 6] = ["llvmpipe", "lavapipe", "softpipe", "swrast", "swiftshader", "basic render driver"];

/// What an adapter is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum AdapterKind {
    /// A card with memory of its own.
    Discrete,
    /// Shares its memory with the processor.
    Integrated,
    /// Lent by the host of a virtual machine.
    Virtual,
    /// The driver does not tell. It may be hardware.
    Other,
    /// A program on the processor.
    Software,
}

impl AdapterKind {
    /// Whether it is known to be hardware.
    #[must_use]
    pub fn is_hardware(self) -> bool {
        matches!(self, Self::Discrete | Self::Integrated | Self::Virtual)
    }

    fn of(info: &wgpu::AdapterInfo) -> Self {
        let name = info.name.to_lowercase();
        if SOFTWARE.iter().any(|known| name.contains(known)) {
            return Self::Software;
        }
        match info.device_type {
            wgpu::DeviceType::DiscreteGpu => Self::Discrete,
            wgpu::DeviceType::IntegratedGpu => Self::Integrated,
            wgpu::DeviceType::VirtualGpu => Self::Virtual,
            wgpu::DeviceType::Cpu => Self::Software,
            wgpu::DeviceType::Other => Self::Other,
        }
    }
}

/// `discrete`, `integrated`, `virtual`, `other` or `software`.
impl fmt::Display for AdapterKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Discrete => "discrete",
            Self::Integrated => "integrated",
            Self::Virtual => "virtual",
            Self::Other => "other",
            Self::Software => "software",
        })
    }
}

/// One adapter as one programming interface shows it. It is shown as `name (backend)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterSummary {
    /// As its driver calls it.
    pub name: String,
    /// What it is made of.
    pub kind: AdapterKind,
    /// The programming interface: `Vulkan`, `Metal`, `DX12` or `GL`. An adapter that several of them show is listed for
    /// each.
    pub backend: &'static str,
    /// The driver and its version, as far as they are told.
    pub driver: String,
    /// What it can do.
    pub limits: AdapterLimits,
    /// Why it cannot be used: a limit that stays behind `wgpu::Limits::default()`. `None` is an adapter that can.
    pub lacks: Option<Lack>,
}

impl AdapterSummary {
    /// An adapter, or a device that was opened with `limits`.
    pub(crate) fn of(info: wgpu::AdapterInfo, limits: &wgpu::Limits) -> Self {
        Self {
            kind: AdapterKind::of(&info),
            backend: backend_name(info.backend),
            driver: [info.driver.trim(), info.driver_info.trim()].join(" ").trim().to_owned(),
            limits: AdapterLimits::of(limits),
            lacks: Lack::of(limits),
            name: info.name,
        }
    }

    /// Hardware before software, then what wgpu knows best.
    fn rank(&self) -> (AdapterKind, Reverse<bool>) {
        (self.kind, Reverse(self.backend != GL))
    }

    fn is_named(&self, part: &str) -> bool {
        self.to_string().to_lowercase().contains(&part.to_lowercase())
    }
}

impl fmt::Display for AdapterSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.name, self.backend)
    }
}

const GL: &str = "GL";

fn backend_name(backend: wgpu::Backend) -> &'static str {
    match backend {
        wgpu::Backend::Vulkan => "Vulkan",
        wgpu::Backend::Metal => "Metal",
        wgpu::Backend::Dx12 => "DX12",
        wgpu::Backend::Gl => GL,
        wgpu::Backend::BrowserWebGpu => "WebGPU",
        wgpu::Backend::Noop => "none",
    }
}

/// Which adapter is wanted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum AdapterChoice {
    /// The first that can be used in the order of [`adapters`]: hardware, and software only where there is no other.
    #[default]
    Any,
    /// The first that can be used and is known to be hardware.
    Hardware,
    /// The first that can be used of those with this text in `name (backend)`, in whatever case.
    Named(String),
}

impl AdapterChoice {
    /// What the environment variable `ORIGAMI_ADAPTER` names; without it [`AdapterChoice::Any`].
    #[must_use]
    pub fn from_env() -> Self {
        match std::env::var(VARIABLE) {
            Ok(name) if !name.trim().is_empty() => Self::Named(name.trim().to_owned()),
            _ => Self::Any,
        }
    }

    /// The place of the adapter to take among `there`, which are in the order of [`adapters`].
    ///
    /// # Errors
    /// [`GpuError::NoAdapter`], [`GpuError::NoHardware`], [`GpuError::NoSuchAdapter`]; [`GpuError::Unfit`] where none of
    /// those that match can be used.
    pub(crate) fn pick(&self, there: &[AdapterSummary]) -> Result<usize, GpuError> {
        if there.is_empty() {
            return Err(GpuError::NoAdapter);
        }
        let names = || there.iter().map(ToString::to_string).collect();
        let matches = |adapter: &AdapterSummary| match self {
            Self::Any => true,
            Self::Hardware => adapter.kind.is_hardware(),
            Self::Named(part) => adapter.is_named(part),
        };
        let matching: Vec<usize> = (0..there.len()).filter(|i| matches(&there[*i])).collect();
        let Some(first) = matching.first() else {
            return Err(match self {
                Self::Named(asked) => GpuError::NoSuchAdapter { asked: asked.clone(), there: names() },
                Self::Any | Self::Hardware => GpuError::NoHardware { there: names() },
            });
        };
        match (matching.iter().find(|i| there[**i].lacks.is_none()), there[*first].lacks) {
            (Some(usable), _) => Ok(*usable),
            (None, Some(lack)) => Err(GpuError::Unfit { adapter: there[*first].to_string(), lack }),
            (None, None) => Ok(*first),
        }
    }
}

/// All adapters: discrete, integrated, virtual, of unknown kind, software; of equal ones those of GL last, and else in the
/// order of the system.
#[must_use]
pub fn adapters() -> Vec<AdapterSummary> {
    found().into_iter().map(|(_, summary)| summary).collect()
}

/// The same with what opens them.
pub(crate) fn found() -> Vec<(wgpu::Adapter, AdapterSummary)> {
    let backends = wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12 | wgpu::Backends::GL;
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    let instance = wgpu::Instance::new(descriptor);
    let adapters = pollster::block_on(instance.enumerate_adapters(backends));
    let mut found: Vec<_> = adapters
        .into_iter()
        .map(|adapter| (AdapterSummary::of(adapter.get_info(), &adapter.limits()), adapter))
        .collect();
    found.sort_by_key(|(summary, _)| summary.rank());
    found.into_iter().map(|(summary, adapter)| (adapter, summary)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn adapter(name: &str, kind: AdapterKind, backend: &'static str) -> AdapterSummary {
        let limits = AdapterLimits {
            storage_buffers_per_stage: 8,
            invocations_per_workgroup: 256,
            workgroup_storage: 16_384,
            storage_binding: 128 << 20,
            buffer: 256 << 20,
        };
        AdapterSummary { name: name.to_owned(), kind, backend, driver: String::new(), limits, lacks: None }
    }

    /// Out of order, with one that cannot be used.
    fn several() -> Vec<AdapterSummary> {
        let mut old = adapter("Voodoo 5", AdapterKind::Discrete, "GL");
        old.lacks = Lack::of(&wgpu::Limits { max_storage_buffers_per_shader_stage: 4, ..wgpu::Limits::default() });
        let mut several = vec![
            adapter("llvmpipe", AdapterKind::Software, "GL"),
            old,
            adapter("llvmpipe", AdapterKind::Software, "Vulkan"),
            adapter("GeForce", AdapterKind::Discrete, "GL"),
            adapter("Iris", AdapterKind::Integrated, "Vulkan"),
            adapter("GeForce", AdapterKind::Discrete, "Vulkan"),
        ];
        several.sort_by_key(AdapterSummary::rank);
        several
    }

    fn picked(choice: &AdapterChoice, there: &[AdapterSummary]) -> Result<String, String> {
        choice.pick(there).map(|i| there[i].to_string()).map_err(|error| error.to_string())
    }

    fn named(part: &str) -> AdapterChoice {
        AdapterChoice::Named(part.to_owned())
    }

    #[test]
    fn hardware_comes_first_and_vulkan_before_gl() {
        let names: Vec<String> = several().iter().map(ToString::to_string).collect();
        let expected = [
            "GeForce (Vulkan)",
            "Voodoo 5 (GL)",
            "GeForce (GL)",
            "Iris (Vulkan)",
            "llvmpipe (Vulkan)",
            "llvmpipe (GL)",
        ];
        assert_eq!(names, expected);
    }

    #[test]
    fn a_part_of_the_name_is_enough() {
        let there = several();
        let cases = [
            ("geforce", "GeForce (Vulkan)"),
            ("GEFORCE (gl", "GeForce (GL)"),
            ("pipe", "llvmpipe (Vulkan)"),
            ("(GL)", "GeForce (GL)"),
            ("iris (vulkan)", "Iris (Vulkan)"),
        ];
        for (part, expected) in cases {
            assert_eq!(picked(&named(part), &there), Ok(expected.to_owned()), "{part}");
        }
    }

    #[test]
    fn what_is_not_there_is_told_with_what_is() {
        let there = several();
        let error = picked(&named("radeon"), &there).unwrap_err();
        assert!(error.starts_with("no GPU adapter is called radeon; expected part of one of these: "), "{error}");
        assert!(there.iter().all(|adapter| error.contains(&adapter.to_string())), "{error}");
        let error = picked(&named("voodoo"), &there).unwrap_err();
        let expected =
            "Voodoo 5 (GL) cannot be used: its max_storage_buffers_per_shader_stage is 4; expected at least 8";
        assert_eq!(error, expected);
        for choice in [AdapterChoice::Any, AdapterChoice::Hardware, named("x")] {
            assert!(matches!(choice.pick(&[]), Err(GpuError::NoAdapter)), "{choice:?}");
        }
    }

    #[test]
    fn software_is_taken_for_want_of_hardware_and_never_for_hardware() {
        let mut there = several();
        for choice in [AdapterChoice::Any, AdapterChoice::Hardware] {
            assert_eq!(picked(&choice, &there), Ok("GeForce (Vulkan)".to_owned()));
        }
        there.retain(|adapter| !adapter.kind.is_hardware());
        assert_eq!(picked(&AdapterChoice::Any, &there), Ok("llvmpipe (Vulkan)".to_owned()));
        let error = picked(&AdapterChoice::Hardware, &there).unwrap_err();
        assert_eq!(error, "no GPU was found but llvmpipe (Vulkan), llvmpipe (GL); expected hardware");
        there.push(adapter("unknown", AdapterKind::Other, "GL"));
        assert!(AdapterChoice::Hardware.pick(&there).is_err(), "it may be software");
    }

    #[test]
    fn one_that_cannot_be_used_is_passed_over() {
        let mut there = several();
        there.retain(|adapter| adapter.backend == GL);
        assert!(there[0].lacks.is_some(), "the old one is first");
        assert_eq!(picked(&AdapterChoice::Any, &there), Ok("GeForce (GL)".to_owned()));
    }

    #[test]
    fn software_is_known_by_its_name_too() {
        let info = |name: &str, kind| wgpu::AdapterInfo {
            name: name.to_owned(),
            ..wgpu::AdapterInfo::new(kind, wgpu::Backend::Gl)
        };
        use wgpu::DeviceType::{Cpu, DiscreteGpu, Other};
        let cases = [
            ("softpipe", Other, AdapterKind::Software),
            ("zink Vulkan 1.3 (llvmpipe)", DiscreteGpu, AdapterKind::Software),
            ("Microsoft Basic Render Driver", Other, AdapterKind::Software),
            ("GeForce", DiscreteGpu, AdapterKind::Discrete),
            ("GeForce", Other, AdapterKind::Other),
            ("GeForce", Cpu, AdapterKind::Software),
        ];
        for (name, reported, expected) in cases {
            assert_eq!(AdapterKind::of(&info(name, reported)), expected, "{name}");
        }
    }

    #[test]
    fn adapters_are_listed_in_the_same_order_each_time() {
        let first = adapters();
        assert_eq!(first, adapters());
        assert!(first.is_sorted_by_key(AdapterSummary::rank));
    }
}
