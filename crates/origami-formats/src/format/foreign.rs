//! What is no crease pattern, by name: so that whoever gave the wrong file is told which it is.

/// The kinds that their first bytes tell.
const BEGINNINGS: [(&[u8], &str); 33] = [
    (b"\x89PNG\r\n", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"BM", "a BMP picture"),
    (b"II*\0", "a TIFF picture"),
    (b"MM\0*", "a TIFF picture"),
    (b"RIFF", "a WebP picture, or sound"),
    (b"8BPS", "a Photoshop picture"),
    (b"%PDF", "a PDF document (Illustrator's files are such too)"),
    (b"%!PS", "a PostScript document"),
    (b"PK\x03\x04", "a ZIP archive"),
    (b"PK\x05\x06", "an empty ZIP archive"),
    (b"BZh", "a bzip2 file"),
    (b"\xfd7zXZ\0", "an xz file"),
    (b"\x28\xb5\x2f\xfd", "a zstd file"),
    (b"7z\xbc\xaf", "a 7-Zip archive"),
    (b"Rar!", "a RAR archive"),
    (b"glTF", "a binary glTF model"),
    (b"AutoCAD Binary DXF", "a binary DXF drawing; written as text it can be read"),
    (b"AC10", "a DWG drawing; saved as DXF it can be read"),
    (b"Kaydara FBX", "an FBX model"),
    (b"BLENDER", "a Blender file"),
    (b"Rhino", "a Rhino model"),
    (b"3D Geometry File Format", "a Rhino model"),
    (b"ply\n", "a PLY model"),
    (b"ply\r\n", "a PLY model"),
    (b"solid ", "an STL model, which has triangles and no creases"),
    (b"ISO-10303-21", "a STEP model"),
    (b"\x7fELF", "a program"),
    (b"MZ", "a program for Windows"),
    (b"SQLite format 3", "an SQLite database"),
    (b"\xd0\xcf\x11\xe0", "an Office document"),
    (b"\x00\x00\x00\x1cftyp", "a film"),
];

/// What a file is that its first bytes or its shape tell to be none of a crease pattern.
pub(super) fn binary(bytes: &[u8]) -> Option<&'static str> {
    let found = BEGINNINGS.iter().find(|(start, _)| bytes.starts_with(start)).map(|(_, name)| *name);
    // Text may begin with these letters too.
    let text = || bytes.iter().take(512).all(|byte| *byte >= 0x20 || byte.is_ascii_whitespace());
    match found {
        Some("a BMP picture" | "a program for Windows" | "a WebP picture, or sound") if text() => None,
        Some(name) => Some(name),
        None if is_binary_stl(bytes) => Some("a binary STL model, which has triangles and no creases"),
        None => None,
    }
}

/// Whether the length is that of as many triangles as the header says.
fn is_binary_stl(bytes: &[u8]) -> bool {
    let count = bytes.get(80..84).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    count.is_some_and(|count| bytes.len() as u64 == 84 + 50 * u64::from(count))
}

/// What an XML file with a root element of this name is.
pub(super) fn xml(root: &str) -> String {
    match root.to_ascii_lowercase().as_str() {
        "html" => "an HTML page, as comes in place of a file when it has to be downloaded otherwise".to_owned(),
        "collada" => "a COLLADA model".to_owned(),
        "kml" => "a KML map".to_owned(),
        "x3d" => "an X3D model".to_owned(),
        "java" => "an XML file of a Java program other than ORIPA".to_owned(),
        _ => format!("an XML file with the root element <{root}>"),
    }
}

/// What a JSON file with these keys at its top is, if it is known and no pattern.
pub(super) fn json(keys: &[String]) -> Option<&'static str> {
    let has = |all: &[&str]| all.iter().all(|key| keys.iter().any(|own| own == key));
    if has(&["asset"]) && (has(&["scenes"]) || has(&["meshes"]) || has(&["nodes"])) {
        Some("a glTF model")
    } else if has(&["type", "features"]) || has(&["type", "geometries"]) {
        Some("a GeoJSON map")
    } else if has(&["nbformat", "cells"]) {
        Some("a Jupyter notebook")
    } else if has(&["design", "version"]) || has(&["layout", "tree"]) {
        Some("a project of Box Pleating Studio; what it exports as CP or FOLD can be read")
    } else if has(&["metadata", "geometries"]) || has(&["metadata", "object"]) {
        Some("a three.js model")
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beginnings_tell_what_a_file_is() {
        assert_eq!(binary(b"\x89PNG\r\n\x1a\n...."), Some("a PNG picture"));
        assert_eq!(binary(b"PK\x03\x04\x14\x00"), Some("a ZIP archive"));
        assert_eq!(binary(b"BM\x00\x00"), Some("a BMP picture"));
        assert_eq!(binary(b"BMVF are letters"), None);
        assert_eq!(binary(b"1 0 0 1 1"), None);
        let mut stl = vec![b'x'; 84 + 100];
        stl[80..84].copy_from_slice(&2_u32.to_le_bytes());
        assert!(binary(&stl).is_some_and(|name| name.contains("STL")));
        assert_eq!(binary(&stl[..183]), None);
    }

    #[test]
    fn keys_tell_what_json_is() {
        let known = |keys: &[&str]| json(&keys.iter().map(|key| (*key).to_owned()).collect::<Vec<_>>());
        assert_eq!(known(&["asset", "meshes"]), Some("a glTF model"));
        assert_eq!(known(&["type", "features"]), Some("a GeoJSON map"));
        assert_eq!(known(&["vertices_coords"]), None);
    }
}
