use super::*;
#[test]
fn debug_faces() {
    for f in ["s05", "s06", "s07", "s08", "s09"] {
        let bytes = std::fs::read(format!("/work/shared/svg/{f}.svg")).unwrap();
        eprintln!("FILE {f}");
        let _ = crate::svg::read(&bytes, &crate::Options::default()).unwrap();
    }
}
