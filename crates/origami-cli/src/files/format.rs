//! Formats, and the extensions that stand for them.

use std::path::Path;

use clap::ValueEnum;

/// A format that folded sheets are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// FOLD: vertices, edges, faces, fold angles, and the order of faces where they lie flat
    Fold,
    /// Wavefront OBJ: faces as in the input, with texture coordinates
    Obj,
    /// Binary STL: triangles
    Stl,
    /// Binary glTF: the folding as an animation, for viewers
    Glb,
    /// A page for any browser: the folding as a film that one can turn
    Html,
    /// A picture of the folded sheet
    Png,
    /// A picture of the crease pattern as SVG
    Svg,
    /// The pattern and stages in one picture; no folder takes these.
    #[value(skip)]
    Contact,
    /// A moving picture, or pictures with numbers.
    #[value(skip)]
    Film,
}

impl Format {
    const ALL: [Self; 7] = [Self::Fold, Self::Obj, Self::Stl, Self::Glb, Self::Html, Self::Png, Self::Svg];

    /// Whether it needs what draws.
    pub(crate) fn is_drawn(self) -> bool {
        !matches!(self, Self::Fold | Self::Obj | Self::Stl | Self::Html)
    }

    /// That of a path's extension, upper or lower case.
    ///
    /// # Errors
    /// What is wrong with the extension.
    pub(crate) fn of(path: &Path) -> Result<Self, String> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let known = Self::ALL.into_iter().find(|format| format.extension() == extension);
        if known == Some(Self::Html) {
            super::page::check().map_err(|error| format!("{}: {error}", path.display()))?;
        }
        known.ok_or_else(|| {
            let problem = match extension.as_str() {
                "" => "no extension tells the format".to_owned(),
                other => format!("the format .{other} is not known"),
            };
            format!(
                "{}: {problem}; expected .fold, .obj, .stl, .glb, .html, .png or .svg, an existing folder or a path ending in /",
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
            Self::Glb => "glb",
            Self::Html => "html",
            Self::Png | Self::Contact | Self::Film => "png",
            Self::Svg => "svg",
        }
    }
}
