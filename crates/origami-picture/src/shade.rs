//! Light on folded paper: a lamp over the viewer's left shoulder and light from all around, a little more from above.

/// How bright a flat piece of paper is: a factor for its linear colour.
///
/// All vectors are of unit length; `normal` points to the side that is seen. `strength` 0 is no shading at all. Paper is
/// matt (Lambert), lit on both sides alike.
#[must_use]
pub fn brightness(normal: [f32; 3], light: [f32; 3], up: [f32; 3], strength: f32) -> f32 {
    let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let key = dot(normal, light).max(0.0);
    let around = 0.5 + 0.5 * dot(normal, up);
    let lit = AMBIENT + KEY * key + SKY * around;
    1.0 + (lit - 1.0) * strength
}

/// Light from all around.
pub const AMBIENT: f32 = 0.38;
/// That of the lamp on paper turned to it.
pub const KEY: f32 = 0.54;
/// What more comes from above.
pub const SKY: f32 = 0.16;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turned_to_the_light_is_brightest_and_none_is_black_or_burnt() {
        let light = [0.0, 0.6, 0.8];
        let up = [0.0, 1.0, 0.0];
        let at = |normal| brightness(normal, light, up, 1.0);
        assert!(at(light) > at([0.0, 0.0, 1.0]) && at([0.0, 0.0, 1.0]) > at([0.0, -0.8, 0.6]));
        assert!(at([0.0, -1.0, 0.0]) > 0.25 && at(light) < 1.08);
        assert_eq!(brightness(light, light, up, 0.0), 1.0);
    }
}
