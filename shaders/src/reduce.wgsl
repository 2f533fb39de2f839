// Sums over a workgroup, in fixed order.

var<workgroup> summed: array<vec4<f32>, WORKGROUP>;

// The sum of `own` over all invocations; every invocation gets it. Called in uniform control flow.
fn workgroup_sum(local: u32, own: vec4<f32>) -> vec4<f32> {
    summed[local] = own;
    workgroupBarrier();
    for (var half = WORKGROUP / 2u; half > 0u; half /= 2u) {
        if (local < half) {
            summed[local] += summed[local + half];
        }
        workgroupBarrier();
    }
    let sum = summed[0];
    workgroupBarrier();
    return sum;
}

// The same with the maxima of the first two numbers.
fn workgroup_maxima_and_sums(local: u32, own: vec4<f32>) -> vec4<f32> {
    summed[local] = own;
    workgroupBarrier();
    for (var half = WORKGROUP / 2u; half > 0u; half /= 2u) {
        if (local < half) {
            summed[local] = maxima_and_sums(summed[local], summed[local + half]);
        }
        workgroupBarrier();
    }
    let both = summed[0];
    workgroupBarrier();
    return both;
}

fn maxima_and_sums(a: vec4<f32>, b: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(max(a.xy, b.xy), a.zw + b.zw);
}
