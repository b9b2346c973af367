#import polygonize/groups
#import polygonize/lattice

// Whether all of the mesh fits, how many groups the later stages take, and what is drawn: all of it or nothing.

// of all items, last of the totals
@group(0) @binding(0) var<storage, read> totals: array<vec4u>;
@group(0) @binding(1) var<storage, read_write> plan_state: Plan;
// an indexed indirect draw
@group(0) @binding(3) var<storage, read_write> draw: array<u32, 5>;
// first, count: of vertices on edges, of those in the middle of loops
@group(0) @binding(4) var<storage, read_write> edge_span: vec4u;
@group(0) @binding(5) var<storage, read_write> middle_span: vec4u;

@compute @workgroup_size(1)
fn plan() {
  let counts = totals[arrayLength(&totals) - 1u];
  let needed = vec3u(counts.x + counts.w, 3u * counts.z, counts.y);
  let overflows = any(needed > lattice.capacities.xyz);
  plan_state.counts = counts;
  plan_state.overflow = vec4u(u32(overflows), 0u, 0u, 0u);
  plan_groups(0u, select(counts.x, 0u, overflows));
  plan_groups(3u, select(counts.y, 0u, overflows));
  plan_groups(6u, select(counts.w, 0u, overflows));
  edge_span = vec4u(0u, counts.x, 0u, 0u);
  middle_span = vec4u(counts.x, counts.w, 0u, 0u);
  draw[0] = select(needed.y, 0u, overflows);
  draw[1] = 1u;
  draw[2] = 0u;
  draw[3] = 0u;
  draw[4] = 0u;
}
