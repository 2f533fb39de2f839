//! Several pictures in one: the pattern and stages of folding, side by side.

use origami_core::Error;

use crate::colour::Rgb;
use crate::image::Image;

/// Lays pictures out in rows of `columns`, each in a cell as large as the largest of them.
///
/// # Errors
/// [`Error::Invalid`] where there is nothing to lay out, or the whole becomes too large for an [`Image`].
pub fn contact_sheet(images: &[Image], columns: u32, background: Option<Rgb>) -> Result<Image, Error> {
    let width = images.iter().map(|image| image.width).max().unwrap_or(0);
    let height = images.iter().map(|image| image.height).max().unwrap_or(0);
    let count = u32::try_from(images.len()).unwrap_or(u32::MAX);
    let columns = columns.clamp(1, count.max(1));
    let rows = count.div_ceil(columns);
    let mut sheet = Image::new(width.saturating_mul(columns), height.saturating_mul(rows), background)?;
    for (place, image) in (0..count).zip(images) {
        let left = place % columns * width + (width - image.width) / 2;
        let top = place / columns * height + (height - image.height) / 2;
        sheet.place(image, left, top);
    }
    Ok(sheet)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_filled_row_by_row() {
        let colours = [Rgb(255, 0, 0), Rgb(0, 255, 0), Rgb(0, 0, 255)];
        let images: Vec<Image> = colours.iter().map(|c| Image::new(4, 2, Some(*c)).unwrap()).collect();
        let sheet = contact_sheet(&images, 2, Some(Rgb::WHITE)).unwrap();
        assert_eq!((sheet.width, sheet.height), (8, 4));
        assert_eq!(sheet.pixel(5, 1), [0, 255, 0, 255]);
        assert_eq!(sheet.pixel(0, 2), [0, 0, 255, 255]);
        assert_eq!(sheet.pixel(5, 3), [255; 4], "an empty cell");
        assert!(contact_sheet(&[], 3, None).is_err());
        assert!(contact_sheet(&vec![images[0].clone(); 5000], 5000, None).is_err(), "20 000 pixels across");
    }
}
