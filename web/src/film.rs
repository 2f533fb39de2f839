//! The page as one file with a film in it, for those who have no program: nothing is fetched, and no solver is behind it.

use std::io::{self, Write};

use flate2::Compression;
use flate2::write::DeflateEncoder;

/// The modules in an order in which each comes after those that it uses.
const MODULES: [&str; 21] = [
    "packet.js",
    "engine.js",
    "model.js",
    "colours.js",
    "camera.js",
    "paint.js",
    "buffers.js",
    "depth.js",
    "painter.js",
    "draft.js",
    "stage.js",
    "flat.js",
    "hand.js",
    "keys.js",
    "panel.js",
    "gallery.js",
    "crossed.js",
    "recording.js",
    "files.js",
    "controls.js",
    "app.js",
];

/// Nothing may be loaded, whatever the film says.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

/// The page with the bytes of a packet of `origami_session::film` in it, packed; `title` is the window's.
///
/// # Errors
/// What packing says; writing to memory does not fail.
pub fn film(packet: &[u8], title: &str) -> io::Result<String> {
    let mut packed = DeflateEncoder::new(Vec::new(), Compression::best());
    packed.write_all(packet)?;
    let data = base64(&packed.finish()?);
    let text = |name| super::file(name).map(|file| file.text).unwrap_or_default();
    let modules: String = MODULES.into_iter().chain(["main.js"]).map(|name| joined(text(name))).collect();
    let icon = format!("data:image/svg+xml;base64,{}", base64(text("icon.svg").as_bytes()));
    let page = text("index.html")
        .replace("<html lang=\"en\">", "<html lang=\"en\" data-engine=\"film\">")
        .replace(
            "<title>origami</title>",
            &format!(
                "<title>{}</title>\n<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">",
                escaped(title)
            ),
        )
        .replace("icon.svg", &icon)
        .replace("<link rel=\"stylesheet\" href=\"style.css\">", &format!("<style>\n{}</style>", text("style.css")))
        .replace("<script type=\"module\" src=\"main.js\"></script>", "");
    let scripts = format!(
        "<script type=\"application/octet-stream\" id=\"film\">{data}</script>\n<script type=\"module\">\n{modules}</script>\n</body>"
    );
    Ok(page.replace("</body>", &scripts))
}

/// A module as a part of one: what it takes from others is there.
fn joined(module: &str) -> String {
    let mut text = String::with_capacity(module.len());
    for line in module.lines().filter(|line| !line.starts_with("import ")) {
        text += line.strip_prefix("export ").unwrap_or(line);
        text.push('\n');
    }
    text
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// RFC 4648, with padding.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let at = |i: usize| u32::from(three.get(i).copied().unwrap_or(0));
        let bits = at(0) << 16 | at(1) << 8 | at(2);
        for i in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * i)) as usize & 63];
            text.push(if i <= three.len() { char::from(digit) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_rfc() {
        let pairs =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")];
        for (bytes, text) in pairs {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    /// Of modules put together none may take from outside, and no name may be given twice.
    #[test]
    fn the_page_is_one_file() {
        let page = film(&[1, 2, 3], "a <b> & c").expect("memory");
        assert!(page.contains("<title>a &lt;b&gt; &amp; c</title>"));
        for outside in ["import ", "href=\"style", "src=\"main", "\"icon.svg\""] {
            assert!(
                !page
                    .lines()
                    .any(|line| line.starts_with(outside) || (outside.contains('"') && line.contains(outside))),
                "{outside}"
            );
        }
        let mut names: Vec<&str> = page
            .lines()
            .filter_map(|line| ["function ", "class ", "const "].iter().find_map(|kind| line.strip_prefix(kind)))
            .map(|rest| rest.split([' ', '(', '=']).next().unwrap_or_default())
            .collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert!(count > 40 && names.len() == count, "{count} names, {} of them different", names.len());
        assert!(page.len() < 125_000, "{} bytes without a film", page.len());
    }
}
