// A loop of vertices as triangles: around the corner that leaves the shortest chords, or around a vertex in the middle. Twin of
// src/field/loopTriangles.ts.

@group(0) @binding(4) var<storage, read_write> positions: array<vec4f>;
@group(0) @binding(5) var<storage, read_write> normals: array<vec4f>;
@group(0) @binding(6) var<storage, read_write> colours: array<vec4f>;
@group(0) @binding(7) var<storage, read_write> indices: array<u32>;

// what is shorter by rounding alone is not
const SHORTER = 0.999;

// vertices, counter-clockwise from outside
var<private> ring: array<u32, 12>;

fn add_triangle(at: u32, a: u32, b: u32, c: u32) {
  indices[at] = a;
  indices[at + 1u] = b;
  indices[at + 2u] = c;
}

fn add_fan(at: u32, length: u32) {
  let first = shortest_fan(length);
  for (var i = 1u; i < length - 1u; i++) {
    let b = ring[(first + i) % length];
    add_triangle(at + 3u * (i - 1u), ring[first], b, ring[(first + i + 1u) % length]);
  }
}

fn add_around(at: u32, middle: u32, length: u32) {
  for (var i = 0u; i < length; i++) {
    add_triangle(at + 3u * i, middle, ring[i], ring[(i + 1u) % length]);
  }
}

fn shortest_fan(length: u32) -> u32 {
  var best = 0u;
  var least = 3e38;
  for (var first = 0u; first < length && length > 3u; first++) {
    var sum = 0.0;
    for (var i = 2u; i < length - 1u; i++) {
      let chord = positions[ring[first]].xyz - positions[ring[(first + i) % length]].xyz;
      sum += dot(chord, chord);
    }
    if (sum < SHORTER * least) {
      least = sum;
      best = first;
    }
  }
  return best;
}

// in the middle of the others, with the mean of their normals and colours
fn add_middle(vertex: u32, length: u32) {
  var position = vec4f(0.0);
  var normal = vec3f(0.0);
  var colour = vec4f(0.0);
  for (var i = 0u; i < length; i++) {
    position += positions[ring[i]];
    normal += normals[ring[i]].xyz;
    colour += colours[ring[i]];
  }
  let size = dot(normal, normal);
  positions[vertex] = position / f32(length);
  normals[vertex] = vec4f(select(normals[ring[0]].xyz, normal * inverseSqrt(size), size > 1e-12), 0.0);
  colours[vertex] = colour / f32(length);
}
