//! The binary chunk: accessors and the bytes that they look at.

use origami_core::glam::Vec3;
use serde_json::{Value, json};

/// Bytes with the accessors and views into them; each begins at a multiple of four.
#[derive(Default)]
pub(super) struct Buffer {
    pub(super) bytes: Vec<u8>,
    pub(super) views: Vec<Value>,
    pub(super) accessors: Vec<Value>,
}

const FLOAT: u32 = 5126;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
/// The view's bytes are vertices.
const ARRAY_BUFFER: u32 = 34962;

impl Buffer {
    /// Vertex positions, or how far they move: glTF wants their least and greatest.
    pub(super) fn positions(&mut self, values: &[Vec3]) -> usize {
        let low = values.iter().copied().reduce(Vec3::min).unwrap_or_default();
        let high = values.iter().copied().reduce(Vec3::max).unwrap_or_default();
        let index = self.normals(values);
        let bounds = |v: Vec3| json!(v.to_array());
        if let Some(accessor) = self.accessors.get_mut(index) {
            accessor["min"] = bounds(low);
            accessor["max"] = bounds(high);
        }
        index
    }

    /// Normals, or how they turn.
    pub(super) fn normals(&mut self, values: &[Vec3]) -> usize {
        let bytes = values.iter().flat_map(|v| v.to_array()).flat_map(f32::to_le_bytes);
        self.put(bytes, values.len(), FLOAT, "VEC3", Some(ARRAY_BUFFER))
    }

    /// Places on a picture.
    pub(super) fn places(&mut self, values: &[[f32; 2]]) -> usize {
        let bytes = values.iter().flatten().copied().flat_map(f32::to_le_bytes);
        self.put(bytes, values.len(), FLOAT, "VEC2", Some(ARRAY_BUFFER))
    }

    /// Linear light as normalised 16 bit numbers, opaque.
    pub(super) fn colours(&mut self, values: &[[f32; 3]]) -> usize {
        let channel = |c: f32| (c.clamp(0.0, 1.0) * 65535.0 + 0.5) as u16;
        let bytes = values.iter().flat_map(|[r, g, b]| [channel(*r), channel(*g), channel(*b), u16::MAX]);
        let index =
            self.put(bytes.flat_map(u16::to_le_bytes), values.len(), UNSIGNED_SHORT, "VEC4", Some(ARRAY_BUFFER));
        if let Some(accessor) = self.accessors.get_mut(index) {
            accessor["normalized"] = json!(true);
        }
        index
    }

    /// Plain numbers, for animations.
    pub(super) fn numbers(&mut self, values: &[f32]) -> usize {
        let low = values.iter().copied().fold(f32::INFINITY, f32::min);
        let high = values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        let index = self.put(values.iter().flat_map(|v| v.to_le_bytes()), values.len(), FLOAT, "SCALAR", None);
        if let Some(accessor) = self.accessors.get_mut(index) {
            accessor["min"] = json!([low]);
            accessor["max"] = json!([high]);
        }
        index
    }

    /// So many numbers that are 1 at these places, which rise, and 0 else. Only the places are written.
    pub(super) fn ones(&mut self, count: usize, places: &[u32]) -> usize {
        let indices = self.view(places.iter().flat_map(|place| place.to_le_bytes()), None);
        let values = self.view(places.iter().flat_map(|_| 1.0_f32.to_le_bytes()), None);
        self.accessors.push(json!({
            "componentType": FLOAT,
            "count": count,
            "type": "SCALAR",
            "min": [0.0],
            "max": [1.0],
            "sparse": {
                "count": places.len(),
                "indices": { "bufferView": indices, "componentType": UNSIGNED_INT },
                "values": { "bufferView": values },
            },
        }));
        self.accessors.len() - 1
    }

    fn put(
        &mut self,
        bytes: impl Iterator<Item = u8>,
        count: usize,
        component: u32,
        shape: &str,
        target: Option<u32>,
    ) -> usize {
        let view = self.view(bytes, target);
        self.accessors.push(json!({ "bufferView": view, "componentType": component, "count": count, "type": shape }));
        self.accessors.len() - 1
    }

    fn view(&mut self, bytes: impl Iterator<Item = u8>, target: Option<u32>) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        let length = self.bytes.len() - start;
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let mut view = json!({ "buffer": 0, "byteOffset": start, "byteLength": length });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        self.views.push(view);
        self.views.len() - 1
    }
}
