#import record/polygon
#import record/edge

// How often a polygon's outline goes round a point of its plane, and how far away that is. Twin of src/skeleton/plateDistance.ts.

struct Rim {
  turns: i32,
  distance2: f32,
}

fn rim_of(skel: Polygon, foot: vec2f) -> Rim {
  var rim = Rim(0, 1e30);
  for (var k = skel.first; k < skel.end; k += EDGE_STRIDE) {
    let edge = load_edge(k);
    let a = edge.start - foot;
    let b = edge.end - foot;
    let nearest = a + clamp(-dot(a, edge.u), 0.0, edge.length) * edge.u;
    rim.distance2 = min(rim.distance2, dot(nearest, nearest));
    rim.turns += crossing(a, b);
  }
  return rim;
}

// 1 where the edge crosses the ray from the origin along x upwards, −1 downwards
fn crossing(a: vec2f, b: vec2f) -> i32 {
  if ((a.y > 0.0) == (b.y > 0.0)) {
    return 0;
  }
  let upwards = b.y > a.y;
  let is_right = (a.x * b.y - a.y * b.x > 0.0) == upwards;
  return select(0, select(-1, 1, upwards), is_right);
}
