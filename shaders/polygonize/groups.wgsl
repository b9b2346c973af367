// What plans write: how much there is, and how many groups later stages take.

struct Plan {
  // as State in state.wgsl
  counts: vec4u,
  overflow: vec4u,
}

// indirect dispatches: of vertices on edges, of cells, of vertices in the middle of loops, of loops around creases
@group(0) @binding(2) var<storage, read_write> dispatches: array<u32, 12>;

// as many groups of 64 as it takes, in rows that no device refuses
fn plan_groups(at: u32, threads: u32) {
  let groups = (threads + 63u) / 64u;
  let rows = (groups + 65534u) / 65535u;
  dispatches[at] = (groups + max(rows, 1u) - 1u) / max(rows, 1u);
  dispatches[at + 1u] = rows;
  dispatches[at + 2u] = 1u;
}
