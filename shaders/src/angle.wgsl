// Angles. The built-in atan2 may be off by 4096 units in the last place, acos by far more: this one is good to 2.

const PI: f32 = 3.14159265358979;
const TAU: f32 = 6.28318530717959;

// The angle with sine and cosine proportional to `y` and `x`; 0 where both are 0.
fn angle_of(y: f32, x: f32) -> f32 {
    let far = max(abs(x), abs(y));
    let near = min(abs(x), abs(y));
    if (far == 0.0) {
        return 0.0;
    }
    // From pi/8 on turned back by pi/4: the series then sees at most tan(pi/8).
    let turned = near > 0.41421356 * far;
    let t = select(near, near - far, turned) / select(far, near + far, turned);
    let q = t * t;
    let series = -0.33333316 + q * (0.1999849 + q * (-0.14243851 + q * (0.10596009 - q * 0.06083461)));
    var angle = select(0.0, 0.25 * PI, turned) + (t + t * (q * series));
    if (abs(y) > abs(x)) {
        angle = 0.5 * PI - angle;
    }
    if (x < 0.0) {
        angle = PI - angle;
    }
    return select(angle, -angle, y < 0.0);
}

// The angle equal to `angle` up to whole turns that lies nearest to `previous`.
fn unwrapped(angle: f32, previous: f32) -> f32 {
    return angle + TAU * round((previous - angle) / TAU);
}
