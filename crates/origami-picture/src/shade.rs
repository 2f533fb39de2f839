//! Light on folded paper: a lamp over the viewer's left shoulder and light from all around, a little more from above.

/// How much light a flat piece of paper has with nothing before it.
///
/// All vectors are of unit length; `normal` points to the side that is seen. Paper is matt, lit on both sides alike. The
/// lamp is a large one: its light reaches around, so that folds turned away from it differ too.
#[must_use]
pub fn lit(normal: [f32; 3], light: [f32; 3], up: [f32; 3]) -> f32 {
    let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let key = 0.5 + 0.5 * dot(normal, light);
    let around = 0.5 + 0.5 * dot(normal, up);
    AMBIENT + KEY * key * key + SKY * around
}

/// How bright paper is that is `lit` so and `open` to so much of the light from all around (0 to 1): a factor for its linear
/// colour. `strength` 0 is no shading at all.
#[must_use]
pub fn brightness(lit: f32, open: f32, strength: f32) -> f32 {
    1.0 + (lit * (1.0 - SHADE * (1.0 - open)) - 1.0) * strength
}

/// Light from all around.
pub const AMBIENT: f32 = 0.42;
/// That of the lamp on paper turned to it.
pub const KEY: f32 = 0.56;
/// What more comes from above.
pub const SKY: f32 = 0.1;
/// How much of its light paper loses that nothing from around reaches.
pub const SHADE: f32 = 0.7;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turned_to_the_light_is_brightest_and_none_is_black_or_burnt() {
        let light = [0.0, 0.6, 0.8];
        let up = [0.0, 1.0, 0.0];
        let at = |normal| brightness(lit(normal, light, up), 1.0, 1.0);
        assert!(at(light) > at([0.0, 0.0, 1.0]) && at([0.0, 0.0, 1.0]) > at([0.0, -0.8, 0.6]));
        assert!(at([0.0, -0.6, -0.8]) > 0.25 && at(light) < 1.08);
        assert!(at([0.0, -0.8, 0.6]) > at([0.0, -1.0, 0.0]), "what is turned away differs too");
        assert_eq!(brightness(lit(light, light, up), 0.3, 0.0), 1.0);
    }

    #[test]
    fn what_is_less_open_is_darker_but_not_black() {
        let of = |open| brightness(1.0, open, 1.0);
        assert!(of(1.0) == 1.0 && of(0.5) < 0.8 && of(0.0) > 0.25);
    }
}
