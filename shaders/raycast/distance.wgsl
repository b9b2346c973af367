// How far the skel was that was evaluated last: of M² of its nearest place all but the core, and kernel units of a mm.
var<private> noted_r2: f32;
var<private> noted_scale: f32;

fn note_distance(r2: f32, scale: f32) {
  noted_r2 = r2;
  noted_scale = scale;
}
