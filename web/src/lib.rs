//! The page of `origami view`, as text. It needs nothing but a browser: plain modules, WebGL 2, no library.
#![forbid(unsafe_code)]

mod film;

pub use film::film;

/// A file of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name; none lies in a folder.
    pub name: &'static str,
    /// Its media type.
    pub media: &'static str,
    /// Its text.
    pub text: &'static str,
}

macro_rules! files {
    ($($name:literal: $media:literal,)*) => {
        /// All files of the page; the first is the page itself.
        pub const FILES: &[File] = &[$(File {
            name: $name,
            media: concat!($media, "; charset=utf-8"),
            text: include_str!(concat!("../page/", $name)),
        },)*];
    };
}

files! {
    "index.html": "text/html",
    "style.css": "text/css",
    "icon.svg": "image/svg+xml",
    "main.js": "text/javascript",
    "app.js": "text/javascript",
    "controls.js": "text/javascript",
    "crossed.js": "text/javascript",
    "recording.js": "text/javascript",
    "files.js": "text/javascript",
    "engine.js": "text/javascript",
    "packet.js": "text/javascript",
    "model.js": "text/javascript",
    "stage.js": "text/javascript",
    "painter.js": "text/javascript",
    "buffers.js": "text/javascript",
    "draft.js": "text/javascript",
    "depth.js": "text/javascript",
    "paint.js": "text/javascript",
    "camera.js": "text/javascript",
    "hand.js": "text/javascript",
    "flat.js": "text/javascript",
    "colours.js": "text/javascript",
    "panel.js": "text/javascript",
    "gallery.js": "text/javascript",
    "keys.js": "text/javascript",
    "worker.js": "text/javascript",
}

/// The file of a name.
#[must_use]
pub fn file(name: &str) -> Option<&'static File> {
    FILES.iter().find(|file| file.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is imported, or named by a tag, is there: nothing is fetched from elsewhere.
    #[test]
    fn the_page_is_whole() {
        let mut found = 0;
        for file in FILES {
            for start in [" from \"./", "src=\"", "href=\"", "import(\"./"] {
                for rest in file.text.split(start).skip(1) {
                    let name = rest.split('"').next().unwrap_or_default();
                    if name.starts_with('#') || name.starts_with("data:") || name.ends_with(".wasm") {
                        continue;
                    }
                    found += 1;
                    assert!(super::file(name).is_some(), "{} names {name}", file.name);
                }
            }
        }
        assert!(found > 10, "{found}");
    }
}
