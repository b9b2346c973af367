#import polygonize/owner

// as compact.wgsl left them
@group(0) @binding(2) var<storage, read> crossings: array<u32>;

// the number of the vertex on an edge (corner, axis) of the cell at `place`
fn vertex_on(place: vec3u, edge: vec4u) -> u32 {
  let n = place + edge.xyz;
  let owner = owner_of_edge(n, edge.w);
  let node = dot(n - 4u * owner.place, vec3u(1u, 5u, 25u));
  let crossing = crossings[128u * u32(owner.number) + node];
  return (crossing >> 3u) + countOneBits(crossing & ((1u << edge.w) - 1u));
}
