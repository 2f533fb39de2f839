//! Pictures kept in the repository to compare with.

#![expect(clippy::unwrap_used, reason = "a test that meets an error fails")]

use std::fs::{self, File};
use std::path::PathBuf;

use origami_picture::Image;
use origami_picture::difference;
pub(crate) use origami_picture::difference::{Difference, TOLERANCE};

/// The difference of two pictures of one size, and what it looks like.
pub(crate) fn compare(a: &Image, b: &Image) -> (Difference, Image) {
    difference::compare(a, b).unwrap()
}

/// Holds a picture against the one of this name in `tests/golden`; `ORIGAMI_UPDATE_GOLDEN=1` puts it there instead. Where
/// they differ, both and their difference are written to the target folder.
pub(crate) fn check(name: &str, image: &Image) {
    let golden = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(format!("{name}.png"));
    if std::env::var_os("ORIGAMI_UPDATE_GOLDEN").is_some_and(|value| value == "1") {
        image.write_png(File::create(&golden).unwrap()).unwrap();
        return;
    }
    let should = read(&golden);
    let (difference, shown) = compare(image, &should);
    if difference.within(&TOLERANCE) {
        return;
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("golden");
    fs::create_dir_all(&folder).unwrap();
    for (what, image) in [("is", image), ("should-be", &should), ("difference", &shown)] {
        image.write_png(File::create(folder.join(format!("{name}-{what}.png"))).unwrap()).unwrap();
    }
    panic!("{name}: {difference:?}, more than {TOLERANCE:?}; see {}", folder.display());
}

/// A PNG file of ours.
pub(crate) fn read(path: &std::path::Path) -> Image {
    let file = File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    if info.color_type == png::ColorType::Rgb {
        pixels = pixels.chunks(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
    }
    Image { width: info.width, height: info.height, pixels }
}
