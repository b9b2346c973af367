// A cube as a leaf sees it.
struct Ball {
  centre: vec3f,
  // around the cube
  radius: f32,
  // by how much places are off
  off: f32,
  // half edge of the cube, in the world
  half: f32,
  is_moved: bool,
  // gradients are turned into the world by it
  inverse: mat3x3f,
}
