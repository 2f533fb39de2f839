//! Directions as jobs and files have them: `true`, `"xz"` or `[true, false, true]`.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::scene::Axes;

/// Directions in which a vertex is held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HeldAxes(pub Axes);

#[derive(Deserialize)]
#[serde(untagged)]
enum Written {
    All(bool),
    Letters(String),
    Each([bool; 3]),
}

/// Those of letters such as `xz`; none where a letter is none of the three.
pub(crate) fn axes_of(letters: &str) -> Option<Axes> {
    letters.chars().try_fold(Axes::default(), |axes, letter| match letter {
        'x' => Some(axes | Axes::X),
        'y' => Some(axes | Axes::Y),
        'z' => Some(axes | Axes::Z),
        _ => None,
    })
}

impl<'de> Deserialize<'de> for HeldAxes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let wrong = || de::Error::custom("expected true, letters such as \"xz\", or [true, false, true]");
        let axes = match Written::deserialize(deserializer).map_err(|_| wrong())? {
            Written::All(all) => Axes { x: all, y: all, z: all },
            Written::Letters(letters) => axes_of(&letters).ok_or_else(wrong)?,
            Written::Each([x, y, z]) => Axes { x, y, z },
        };
        Ok(Self(axes))
    }
}

impl Serialize for HeldAxes {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.to_array().serialize(serializer)
    }
}
