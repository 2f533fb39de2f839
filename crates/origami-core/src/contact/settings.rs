//! How paper keeps away from paper.

/// Contact of a sheet with itself.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct Contact {
    /// The gap from which layers push each other away, in radii; above 0. Smaller: layers lie closer and creases come nearer to
    /// their angles, for more evaluations. Default 1e-3.
    pub gap: f64,
    /// How stiff that push is, in the model's unit of force per radius; above 0. Larger: layers under pressure keep more of the
    /// gap, for more evaluations; nothing goes through in either case. Default 50, about half of what a beam is.
    pub stiffness: f64,
}

impl Default for Contact {
    fn default() -> Self {
        Self { gap: 1e-3, stiffness: 50.0 }
    }
}
