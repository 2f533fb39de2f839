//! How paper keeps away from paper.

/// Contact of a sheet with itself.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Contact {
    /// The gap from which layers push each other away, in radii; above 0. Smaller: layers lie closer and creases come nearer to
    /// their angles, for more evaluations. Default 1e-3.
    pub gap: f64,
    /// How thick the paper is, in radii: how far apart the middle planes of layers come to lie, give or take half a gap. Two
    /// faces that share a crease are a wedge, which is as thick at their centroids and closes at the crease. Larger: thicker;
    /// not to be larger than the smallest faces. Default 0.
    pub thickness: f64,
    /// How stiff that push is, in the model's unit of force per radius; above 0. Larger: layers under pressure keep more of the
    /// gap, for more evaluations; nothing goes through in either case. Default 50, about half of what a beam is.
    pub stiffness: f64,
}

impl Contact {
    /// Paper so thick, in radii, above 0; layers come to lie so far apart, give or take a twentieth of that.
    #[must_use]
    pub fn thick(thickness: f64) -> Self {
        Self { gap: 0.1 * thickness, thickness, ..Self::default() }
    }

    /// The distance at which layers are closed, in radii: half a gap less than the thickness, for they rest about half way.
    pub(super) fn closed(self) -> f64 {
        (self.thickness - 0.5 * self.gap).max(0.0)
    }
}

impl Default for Contact {
    fn default() -> Self {
        Self { gap: 1e-3, thickness: 0.0, stiffness: 50.0 }
    }
}
