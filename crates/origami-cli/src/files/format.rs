//! Formats of geometry, and the extensions that stand for them.

use std::path::Path;

use clap::ValueEnum;

/// A format that geometry is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// FOLD: vertices, edges, faces, fold angles
    Fold,
    /// Wavefront OBJ: faces as in the input, with texture coordinates
    Obj,
    /// Binary STL: triangles
    Stl,
}

impl Format {
    /// That of a path's extension, upper or lower case.
    ///
    /// # Errors
    /// What is wrong with the extension.
    pub(crate) fn of(path: &Path) -> Result<Self, String> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let known = [Self::Fold, Self::Obj, Self::Stl].into_iter().find(|format| format.extension() == extension);
        known.ok_or_else(|| {
            let problem = match extension.as_str() {
                "" => "no extension tells the format".to_owned(),
                other => format!("the format .{other} is not known"),
            };
            format!(
                "{}: {problem}; expected .fold, .obj or .stl, an existing folder or a path ending in /",
                path.display()
            )
        })
    }

    /// Without the dot.
    pub(crate) fn extension(self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::Obj => "obj",
            Self::Stl => "stl",
        }
    }
}
