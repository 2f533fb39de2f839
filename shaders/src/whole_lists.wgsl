// Where the passes over all elements find creases and triangles: by their indices in the model.

@group(0) @binding(3) var<storage, read> hinges: array<Hinge>;
@group(0) @binding(4) var<storage, read> faces: array<Face>;

fn hinge_at(c: u32) -> Hinge {
    return hinges[c];
}

fn face_at(f: u32) -> Face {
    return faces[f];
}
