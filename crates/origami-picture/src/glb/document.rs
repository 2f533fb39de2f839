//! The JSON chunk, and both chunks put together.

use origami_core::Error;
use origami_core::glam::{DVec3, Vec3};
use serde_json::{Map, Value, json};

use super::buffer::Buffer;
use super::{normals, positions_of};

/// Draws pairs of vertices as lines.
const LINES: u32 = 1;
/// States whose table of weights is written in full, as every viewer knows it: 64 kB. The table grows with their square.
const DENSE: usize = 128;
const PAPER: usize = 0;
const INK: usize = 1;

pub(super) struct Document {
    buffer: Buffer,
    /// The unit of length, in radii of the figure.
    radius: f32,
    primitives: Vec<Value>,
    materials: Vec<Value>,
    animation: Option<Value>,
    targets: usize,
}

impl Document {
    pub(super) fn new(buffer: Buffer, radius: f32) -> Self {
        Self { buffer, radius, primitives: Vec::new(), materials: Vec::new(), animation: None, targets: 0 }
    }

    /// Triangles with the given corners, and the place of each on a picture; their colours are those of `corner_colours`, or `paper` everywhere.
    pub(super) fn faces(
        &mut self,
        corners: &[u32],
        states: &[Vec<[f32; 3]>],
        texture: Option<&[[f32; 2]]>,
        corner_colours: Option<Vec<[f32; 3]>>,
        paper: [f32; 3],
    ) {
        let first = positions_of(corners, &states[0], self.radius);
        let first_normals = normals(&first);
        let mut attributes = Map::new();
        attributes.insert("POSITION".into(), self.buffer.positions(&first).into());
        attributes.insert("NORMAL".into(), self.buffer.normals(&first_normals).into());
        if let Some(texture) = texture {
            attributes.insert("TEXCOORD_0".into(), self.buffer.places(texture).into());
        }
        let [r, g, b] = if corner_colours.is_some() { [1.0; 3] } else { paper };
        if let Some(colours) = corner_colours {
            attributes.insert("COLOR_0".into(), self.buffer.colours(&colours).into());
        }
        let targets = states[1..].iter().map(|state| {
            let there = positions_of(corners, state, self.radius);
            let turned = difference(&normals(&there), &first_normals);
            let position = self.buffer.positions(&difference(&there, &first));
            json!({ "POSITION": position, "NORMAL": self.buffer.normals(&turned) })
        });
        let targets: Vec<Value> = targets.collect();
        self.targets = targets.len();
        self.primitives.push(primitive(attributes, PAPER, targets));
        self.materials.push(json!({
            "name": "paper",
            "doubleSided": true,
            "pbrMetallicRoughness": { "baseColorFactor": [r, g, b, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.9 },
        }));
    }

    /// Lines between pairs of nodes, coloured at their ends.
    pub(super) fn lines(&mut self, ends: &[u32], states: &[Vec<[f32; 3]>], colours: Vec<[f32; 3]>) {
        let first = positions_of(ends, &states[0], self.radius);
        let mut attributes = Map::new();
        attributes.insert("POSITION".into(), self.buffer.positions(&first).into());
        attributes.insert("COLOR_0".into(), self.buffer.colours(&colours).into());
        let targets = states[1..].iter().map(|state| {
            let moved = difference(&positions_of(ends, state, self.radius), &first);
            json!({ "POSITION": self.buffer.positions(&moved) })
        });
        let targets = targets.collect();
        let mut lines = primitive(attributes, INK, targets);
        lines["mode"] = json!(LINES);
        self.primitives.push(lines);
        self.materials.push(json!({
            "name": "ink",
            "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 1.0 },
            "extensions": { "KHR_materials_unlit": {} },
        }));
    }

    /// Goes from each of so many states to the next.
    pub(super) fn animate(&mut self, states: usize, seconds: f32) {
        if states < 2 {
            return;
        }
        let times: Vec<f32> = (0..states).map(|i| seconds * i as f32 / (states - 1) as f32).collect();
        // At state i the target i - 1 counts fully, and no other.
        let targets = states - 1;
        let input = self.buffer.numbers(&times);
        let output = if states <= DENSE {
            let weights = (0..states).flat_map(|i| (1..states).map(move |target| f32::from(u8::from(i == target))));
            self.buffer.numbers(&weights.collect::<Vec<f32>>())
        } else {
            let ones = (1..states).filter_map(|i| u32::try_from(i * targets + i - 1).ok());
            self.buffer.ones(states * targets, &ones.collect::<Vec<u32>>())
        };
        self.animation = Some(json!({
            "name": "folding",
            "channels": [{ "sampler": 0, "target": { "node": 0, "path": "weights" } }],
            "samplers": [{ "input": input, "output": output, "interpolation": "LINEAR" }],
        }));
    }

    /// The bytes of the file, its vertices about `centre`.
    pub(super) fn into_bytes(self, centre: DVec3) -> Result<Vec<u8>, Error> {
        let mut mesh = json!({ "name": "sheet", "primitives": self.primitives });
        if self.targets > 0 {
            mesh["weights"] = json!(vec![0.0; self.targets]);
        }
        let mut root = json!({
            "asset": { "version": "2.0", "generator": concat!("origami ", env!("CARGO_PKG_VERSION")) },
            "scene": 0,
            "scenes": [{ "nodes": [0] }],
            "nodes": [{ "name": "sheet", "mesh": 0, "translation": [centre.x, centre.z, 0.0 - centre.y] }],
            "meshes": [mesh],
            "materials": self.materials,
            "accessors": self.buffer.accessors,
            "bufferViews": self.buffer.views,
            "buffers": [{ "byteLength": self.buffer.bytes.len() }],
        });
        if self.materials.len() > INK {
            root["extensionsUsed"] = json!(["KHR_materials_unlit"]);
        }
        if let Some(animation) = self.animation {
            root["animations"] = json!([animation]);
        }
        let mut text = root.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let length = 12 + 8 + text.len() + 8 + self.buffer.bytes.len();
        let too_large = |_| Error::invalid("glTF", format!("{length} bytes"), "at most 4 GB: fewer states");
        let word = |value: usize| u32::try_from(value).map(u32::to_le_bytes).map_err(too_large);
        let mut file = Vec::with_capacity(length);
        file.extend(b"glTF");
        file.extend(word(2)?);
        file.extend(word(length)?);
        file.extend(word(text.len())?);
        file.extend(b"JSON");
        file.extend(&text);
        file.extend(word(self.buffer.bytes.len())?);
        file.extend(b"BIN\0");
        file.extend(&self.buffer.bytes);
        Ok(file)
    }
}

fn primitive(attributes: Map<String, Value>, material: usize, targets: Vec<Value>) -> Value {
    let mut primitive = json!({ "attributes": attributes, "material": material });
    if !targets.is_empty() {
        primitive["targets"] = json!(targets);
    }
    primitive
}

fn difference(to: &[Vec3], from: &[Vec3]) -> Vec<Vec3> {
    to.iter().zip(from).map(|(to, from)| *to - *from).collect()
}
