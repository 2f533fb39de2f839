//! `--backend`, `--adapter` and `origami adapters`, in builds with GPUs and without.

#[cfg(not(feature = "gpu"))]
mod absent {
    use crate::place::Place;

    #[test]
    fn a_build_without_gpus_says_so() {
        let place = Place::new();
        for words in ["adapters", "adapters --json", "fold square.fold -o a.fold --backend gpu"] {
            let ran = place.run(words);
            ran.fails(1, "this build has no GPU backend (feature `gpu`)");
            assert_eq!((ran.stdout.as_str(), place.names()), ("", vec!["square.fold".to_owned()]));
        }
        let ran = place.run("fold square.fold -o a.fold --adapter llvmpipe");
        assert_eq!(ran.code, 0);
        assert_eq!(ran.stderr, "warning: --adapter has no effect in a build without the feature `gpu`\n");
    }
}

#[cfg(feature = "gpu")]
mod present {
    use std::io::Write;
    use std::path::Path;
    use std::sync::OnceLock;

    use serde_json::{Value, json};

    use crate::place::Place;

    /// What `origami adapters --json` lists. Without any, one line says that tests are skipped, or the test fails where
    /// `ORIGAMI_REQUIRE_GPU` is set.
    fn adapters(place: &Place) -> Option<Vec<Value>> {
        static TOLD: OnceLock<()> = OnceLock::new();
        let listed = listed(place);
        if listed.is_empty() {
            assert!(std::env::var_os("ORIGAMI_REQUIRE_GPU").is_none(), "ORIGAMI_REQUIRE_GPU is set and there is none");
            TOLD.get_or_init(|| {
                let _ = std::io::stderr().write_all(b"\ntests of --backend gpu are skipped: there is no adapter\n");
            });
            return None;
        }
        Some(listed)
    }

    fn listed(place: &Place) -> Vec<Value> {
        serde_json::from_str(place.run("adapters --json").succeeds()).unwrap()
    }

    fn text<'a>(adapter: &'a Value, key: &str) -> &'a str {
        adapter[key].as_str().unwrap()
    }

    #[test]
    fn the_list_has_the_keys_that_the_document_promises() {
        let Some(adapters) = adapters(&Place::new()) else { return };
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/REPORT.md");
        let document = std::fs::read_to_string(path).unwrap();
        let (_, section) = document.split_once("## `origami adapters --json`").unwrap();
        for adapter in &adapters {
            let found: Vec<&String> = adapter.as_object().unwrap().keys().collect();
            let promised = section.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
            assert_eq!(found, promised.collect::<Vec<_>>());
            assert!(adapter["buffer"].as_u64() >= adapter["storage_binding"].as_u64());
        }
        let software: Vec<bool> = adapters.iter().map(|a| a["kind"] == json!("software")).collect();
        assert!(software.is_sorted(), "hardware comes first");
    }

    #[test]
    fn the_table_has_a_line_for_each() {
        let place = Place::new();
        let Some(adapters) = adapters(&place) else { return };
        let ran = place.run("adapters");
        let lines: Vec<&str> = ran.succeeds().lines().filter(|line| !line.starts_with(' ')).collect();
        assert_eq!(lines.len(), 1 + adapters.len());
        for (line, adapter) in lines[1..].iter().zip(&adapters) {
            assert!(line.starts_with(text(adapter, "kind")) && line.contains(text(adapter, "name")), "{line}");
        }
    }

    #[test]
    fn a_gpu_is_used_and_named_in_the_report() {
        let place = Place::new();
        let Some(adapters) = adapters(&place) else { return };
        let first = adapters.iter().find(|adapter| adapter["unfit"].is_null()).unwrap();
        for solver in ["relax", "dynamics --time-step safe"] {
            let ran = place.run(&format!("fold square.fold -o a.fold --report r.json --backend gpu --solver {solver}"));
            assert_eq!(ran.code, 0, "{}", ran.stderr);
            let report = place.json("r.json");
            assert_eq!((&report["backend"], &report["converged"]), (&json!("gpu"), &json!(true)));
            let keys: Vec<&String> = report["adapter"].as_object().unwrap().keys().collect();
            assert_eq!(keys, ["name", "kind", "driver", "backend"]);
            assert!(keys.iter().all(|key| report["adapter"][key] == first[key]), "{report} is not on {first}");
            let software = format!(", on {} (software), ", text(first, "name"));
            assert_eq!(ran.stdout.contains(&software), text(first, "kind") == "software", "{}", ran.stdout);
        }
    }

    #[test]
    fn contact_is_kept_on_a_gpu_where_it_is_asked_for() {
        let place = Place::new();
        let Some(_) = adapters(&place) else { return };
        let ran = place.run("fold square.fold -o a.fold --report r.json --contact --frames 2 --backend gpu");
        assert_eq!(ran.code, 0, "{}", ran.stderr);
        let report = place.json("r.json");
        assert_eq!((&report["backend"], &report["precision"]), (&json!("gpu"), &json!("f32")));
        let frames = report["frames"].as_array().unwrap();
        assert!(frames.len() > 1 && frames.iter().all(|frame| frame["crossings"]["count"] == json!(0)), "{report}");
        let has =
            |key: &str, what: &str| report[key].as_array().unwrap().iter().any(|line| line["what"] == json!(what));
        assert!(has("built", "passes over pairs that may touch"), "{}", report["built"]);
        assert!(has("left_out", "thickness of pairs"), "{}", report["left_out"]);
        let words = "fold square.fold -o b.fold --backend gpu";
        place.run(&format!("{words} --contact-gap 1e-6")).fails(1, "contact gap in radii: 1e-6; a GPU computes in f32");
        place
            .run(&format!("{words} --contact --sequence own"))
            .fails(1, "--backend gpu: --sequence runs on the processor");
        place.run("fold square.fold --report r.json --contact --backend auto").succeeds();
        assert_eq!(place.json("r.json")["backend"], json!("cpu"), "not by itself");
    }

    #[test]
    fn an_adapter_is_chosen_by_name_or_by_the_environment() {
        let place = Place::new();
        let Some(adapters) = adapters(&place) else { return };
        let last = adapters.iter().rfind(|adapter| adapter["unfit"].is_null()).unwrap();
        let name = format!("{} ({})", text(last, "name"), text(last, "backend")).to_uppercase();
        let words = "fold square.fold --report r.json --quiet --backend gpu";
        let by_name = place.command().args(words.split(' ')).args(["--adapter", &name]).output().unwrap();
        assert!(by_name.status.success(), "{by_name:?}");
        assert_eq!(place.json("r.json")["adapter"]["backend"], last["backend"]);
        std::fs::remove_file(place.path("r.json")).unwrap();
        let by_variable = place.command().args(words.split(' ')).env("ORIGAMI_ADAPTER", &name).output().unwrap();
        assert!(by_variable.status.success(), "{by_variable:?}");
        assert_eq!(place.json("r.json")["adapter"]["backend"], last["backend"]);
    }

    #[test]
    fn a_name_that_is_not_there_is_refused_before_anything_is_written() {
        let place = Place::new();
        let Some(adapters) = adapters(&place) else { return };
        let ran = place.run("fold square.fold -o a.fold --backend gpu --adapter abacus");
        ran.fails(1, "--backend gpu: no GPU adapter is called abacus; expected part of one of these: ");
        assert!(adapters.iter().all(|adapter| ran.stderr.contains(text(adapter, "name"))), "{}", ran.stderr);
        assert_eq!(place.names(), ["square.fold"]);
    }

    #[test]
    fn left_alone_small_sheets_stay_on_the_processor() {
        let place = Place::new();
        // No adapter is looked for, or the name would be told of: the environment's is meant for other runs too.
        let words = "fold square.fold --report r.json --quiet";
        let output = place.command().args(words.split(' ')).env("ORIGAMI_ADAPTER", "abacus").output().unwrap();
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        assert_eq!(place.json("r.json")["backend"], json!("cpu"));
    }

    #[test]
    fn a_misspelt_name_is_refused_whatever_the_size() {
        let place = Place::new();
        if adapters(&place).is_none() {
            return;
        }
        for words in ["fold square.fold -o a.fold", "sweep square.fold -o out --backend auto"] {
            let ran = place.run(&format!("{words} --adapter abacus"));
            ran.fails(1, "error: --adapter: no GPU adapter is called abacus; expected part of one of these: ");
            assert_eq!(place.names(), ["square.fold"]);
        }
    }

    #[test]
    fn numbers_beyond_f32_are_refused_by_the_name_of_their_option() {
        let place = Place::new();
        if adapters(&place).is_none() {
            return;
        }
        for (options, name) in [
            ("--ea 1e39", "--ea 1e39"),
            ("--k-fold 1e300", "--k-fold 1e300"),
            ("--k-face 1e-40", "--k-face 1e-40"),
            ("--tolerance 1e-50", "--tolerance 1e-50"),
            ("--solver dynamics --time-step 1e-60", "--time-step 1e-60"),
        ] {
            let ran = place.run(&format!("fold square.fold -o a.fold --backend gpu {options}"));
            ran.fails(
                1,
                &format!("error: {name}: GPUs compute in f32, which is too narrow for it; expected 1e-30 to 1e30"),
            );
            assert_eq!(place.names(), ["square.fold"]);
        }
        let ran = place.run("sweep square.fold -o out --backend gpu --ea 20,1e39");
        ran.fails(1, "error: --ea 1e39: GPUs compute in f32");
        // Left alone, the processor takes them; nothing is nothing in any precision.
        let ran = place.run("fold square.fold -o a.fold --steps 1 --report r.json --k-fold 1e39");
        assert_eq!((ran.code, &place.json("r.json")["backend"]), (0, &json!("cpu")), "{}", ran.stderr);
        let ran = place.run("fold square.fold -o a.fold --steps 1 --backend gpu --k-face 0");
        assert_eq!(ran.code, 0, "{}", ran.stderr);
    }

    #[test]
    fn left_alone_large_sheets_go_to_hardware_only() {
        let place = Place::new();
        let Some(adapters) = adapters(&place) else { return };
        place.run("pattern miura --set columns=100 --set rows=100 -o large.fold").succeeds();
        let words = "fold large.fold --report r.json --steps 1";
        let ran = place.run(words);
        let hardware = |adapter: &Value| ["discrete", "integrated", "virtual"].contains(&text(adapter, "kind"));
        let usable = |adapter: &&Value| adapter["unfit"].is_null() && hardware(adapter);
        let expected = adapters.iter().find(usable).map_or(Value::Null, |adapter| adapter["name"].clone());
        let report = place.json("r.json");
        assert!(report["vertices"].as_u64() >= Some(10_000), "large enough");
        assert_eq!(report["adapter"].get("name").unwrap_or(&Value::Null), &expected);
        assert_eq!(ran.stderr, "", "nobody is told of what nobody asked for");

        if let Some(software) = adapters.iter().find(|adapter| text(adapter, "kind") == "software") {
            let name = format!("{} ({})", text(software, "name"), text(software, "backend"));
            let output = place.command().args(words.split(' ')).args(["--adapter", &name]).output().unwrap();
            assert_eq!(place.json("r.json")["backend"], json!("cpu"));
            let told = String::from_utf8(output.stderr).unwrap();
            assert_eq!(
                told,
                format!(
                    "warning: --backend auto: the processor, since {name} is not hardware; --backend gpu takes it\n"
                )
            );
        }
        let ran = place.run(&format!("{words} --adapter abacus"));
        ran.fails(1, "error: --adapter: no GPU adapter is called abacus; ");
    }

    /// The loaders of Vulkan and EGL on Linux look for drivers where these variables say.
    #[cfg(target_os = "linux")]
    #[test]
    fn without_any_adapter_one_sentence_tells_what_to_install() {
        let place = Place::new();
        let run = |words: &str| {
            let mut command = place.command();
            for name in ["VK_ICD_FILENAMES", "VK_DRIVER_FILES", "__EGL_VENDOR_LIBRARY_FILENAMES"] {
                command.env(name, "/nonexistent.json");
            }
            let output = command.args(words.split(' ')).output().unwrap();
            let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
            (output.status.code(), stdout, stderr)
        };
        let hint = "no GPU adapter was found; `sudo apt-get install mesa-vulkan-drivers` on Debian and Ubuntu, \
                    or `sudo dnf install mesa-vulkan-drivers` on Fedora, installs a software one\n";
        assert_eq!(run("adapters"), (Some(0), hint.to_owned(), String::new()));
        assert_eq!(run("adapters --json"), (Some(0), "[]\n".to_owned(), String::new()));
        let refused = run("fold square.fold -o a.fold --backend gpu");
        assert_eq!(refused, (Some(1), String::new(), format!("error: --backend gpu: {hint}")));
        assert_eq!(place.names(), ["square.fold"]);
        assert_eq!(run("fold square.fold -o a.fold").0, Some(0), "the processor is always there");
    }

    #[test]
    fn what_single_precision_cannot_resolve_is_told() {
        let place = Place::new();
        if adapters(&place).is_none() {
            return;
        }
        let soft = "fold square.fold -o a.fold --steps 5 --k-fold 1e-7 --k-facet 1e-7";
        let ran = place.run(&format!("{soft} --backend gpu"));
        assert!(ran.code == 0 && ran.stderr.contains("single precision moves it by about "), "{}", ran.stderr);
        for words in [&format!("{soft} --backend cpu"), "fold square.fold -o a.fold --steps 5 --backend gpu"] {
            let ran = place.run(words);
            assert!(ran.code == 0 && !ran.stderr.contains("single precision"), "{}", ran.stderr);
        }
    }
}
