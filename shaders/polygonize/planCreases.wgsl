#import polygonize/groups
#import polygonize/lattice

// What loops around creases add to the plan: a vertex for each side, and two triangles, for theirs go around a point. All of the mesh fits, or nothing is drawn.

// of all cells, last of the totals: loops, vertices
@group(0) @binding(0) var<storage, read> totals: array<vec4u>;
@group(0) @binding(1) var<storage, read_write> plan_state: Plan;
// an indexed indirect draw
@group(0) @binding(3) var<storage, read_write> draw: array<u32, 5>;

@compute @workgroup_size(1)
fn planCreases() {
  let more = totals[arrayLength(&totals) - 1u];
  let counts = plan_state.counts;
  let needed = vec2u(counts.x + counts.w + more.y, 3u * (counts.z + 2u * more.x));
  let overflows = plan_state.overflow.x != 0u || any(needed > lattice.capacities.xy);
  plan_state.overflow = vec4u(u32(overflows), more.xy, 0u);
  plan_groups(9u, select(more.x, 0u, overflows));
  draw[0] = select(needed.y, 0u, overflows);
}
