// What the plan found, for the stages after it.

struct State {
  // vertices on edges, crossed cells, triangles, vertices in the middle of loops
  counts: vec4u,
  // not 0 where a buffer is too small: nothing is written then
  overflow: u32,
  // loops that may be around creases, and vertices there
  creased_loops: u32,
  copies: u32,
}

@group(0) @binding(10) var<uniform> state: State;
