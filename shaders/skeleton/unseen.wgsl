// Where nobody asks how far a skel was. Rays do: raycast/distance.wgsl.
fn note_distance(r2: f32, scale: f32) {}
