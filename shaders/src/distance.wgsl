// The nearest points of a point and a triangle, and of two edges: within both, or at an end of one. As `distance.rs` of the
// core, but in the order in which f32 suffices: normals are cross products of differences in two parts, which keep their
// digits where edges are nearly parallel and gaps are small.

// The squared sine from which two edges are not too parallel to have nearest points within both.
override PARALLEL: f32;

// By how much a point within a segment may be farther than an end and be taken all the same: what is nearly as near as an end has
// the normal of the segment.
const TIE: f32 = 1.000001;

struct Nearest {
    // Weights of the four points: their sum with these is `apart`.
    weights: vec4<f32>,
    // From the nearest point of the second thing to that of the first.
    apart: vec3<f32>,
    // Its square, or a little more, for comparisons.
    squared: f32,
}

// Of a point and a segment, at this share of its way.
fn at_share(weights: vec4<f32>, apart: vec3<f32>, share: f32) -> Nearest {
    let is_within = share > 0.0 && share < 1.0;
    return Nearest(weights, apart, dot(apart, apart) * select(TIE, 1.0, is_within));
}

fn nearer(one: Nearest, other: Nearest) -> Nearest {
    if (other.squared < one.squared) {
        return other;
    }
    return one;
}

// Where a segment is nearest to a point, as a share of its way in `w`, and the vector from there to the point; `to_point` is from
// its start.
fn on_segment(to_point: vec3<f32>, along: vec3<f32>) -> vec4<f32> {
    let squared = max(dot(along, along), 1e-30);
    let share = clamp(dot(to_point, along) / squared, 0.0, 1.0);
    var apart = to_point - share * along;
    if (share > 0.0 && share < 1.0) {
        // What is left along the segment is rounding, and would turn the normal of a small gap.
        apart -= along * (dot(apart, along) / squared);
    }
    return vec4<f32>(apart, share);
}

fn of_point_and_triangle(p: SplitVector, a: SplitVector, b: SplitVector, c: SplitVector) -> Nearest {
    let ab = vector(difference(a, b));
    let ac = vector(difference(a, c));
    let ap = vector(difference(a, p));
    let normal = cross_product(difference(a, b), difference(a, c));
    let squared = max(dot(normal, normal), 1e-30);
    let v = dot(cross_product(difference(a, p), difference(a, c)), normal) / squared;
    let w = dot(cross_product(difference(a, b), difference(a, p)), normal) / squared;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) {
        return Nearest(vec4<f32>(1.0, v + w - 1.0, -v, -w), normal * (dot(ap, normal) / squared), 0.0);
    }
    let one = on_segment(ap, ab);
    let two = on_segment(vector(difference(b, p)), vector(difference(b, c)));
    let three = on_segment(ap, ac);
    let on_ab = at_share(vec4<f32>(1.0, one.w - 1.0, -one.w, 0.0), one.xyz, one.w);
    let on_bc = at_share(vec4<f32>(1.0, 0.0, two.w - 1.0, -two.w), two.xyz, two.w);
    let on_ac = at_share(vec4<f32>(1.0, three.w - 1.0, 0.0, -three.w), three.xyz, three.w);
    return nearer(nearer(on_ab, on_bc), on_ac);
}

// Of the edges from p to q and from r to s.
fn of_edges(p: SplitVector, q: SplitVector, r: SplitVector, s: SplitVector) -> Nearest {
    let u = vector(difference(p, q));
    let v = vector(difference(r, s));
    let pr = vector(difference(p, r));
    let normal = cross_product(difference(p, q), difference(r, s));
    let squared = dot(normal, normal);
    if (squared > PARALLEL * dot(u, u) * dot(v, v)) {
        let first = dot(cross_product(difference(p, r), difference(r, s)), normal) / squared;
        let second = dot(cross_product(difference(p, r), difference(p, q)), normal) / squared;
        if (first >= 0.0 && first <= 1.0 && second >= 0.0 && second <= 1.0) {
            let weights = vec4<f32>(1.0 - first, first, second - 1.0, -second);
            return Nearest(weights, normal * (-dot(pr, normal) / squared), 0.0);
        }
    }
    let of_p = on_segment(-pr, v);
    let of_q = on_segment(vector(difference(r, q)), v);
    let of_r = on_segment(pr, u);
    let of_s = on_segment(vector(difference(p, s)), u);
    let at_p = at_share(vec4<f32>(1.0, 0.0, of_p.w - 1.0, -of_p.w), of_p.xyz, of_p.w);
    let at_q = at_share(vec4<f32>(0.0, 1.0, of_q.w - 1.0, -of_q.w), of_q.xyz, of_q.w);
    let at_r = at_share(vec4<f32>(1.0 - of_r.w, of_r.w, -1.0, 0.0), -of_r.xyz, of_r.w);
    let at_s = at_share(vec4<f32>(1.0 - of_s.w, of_s.w, 0.0, -1.0), -of_s.xyz, of_s.w);
    return nearer(nearer(at_p, at_q), nearer(at_r, at_s));
}
