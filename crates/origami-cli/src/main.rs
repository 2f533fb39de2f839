//! The command `origami`.
fn main() {}
