// A sheet that is as stiff as its material all the way.

fn softens(instance: u32) -> bool {
    return false;
}

fn rigidity_now(instance: u32, own: f32) -> f32 {
    return own;
}

fn corner_share(instance: u32) -> f32 {
    return 1.0;
}

fn wrong_side(instance: u32, angle: f32, target_now: f32) -> f32 {
    return 0.0;
}
