//! The WGSL compute shaders of origami.
#![forbid(unsafe_code)]
