#import record/program
#import record/term
#import skeleton

// The field of the first skel at the first point, of the second at the second, …: (value, gradient).

@group(0) @binding(0) var<storage, read> points: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> values: array<vec4f>;

@compute @workgroup_size(64)
fn each_at_its_point(@builtin(global_invocation_id) id: vec3u) {
  let i = id.x;
  if (i >= arrayLength(&points)) {
    return;
  }
  let term = load_term(load_program(0u).first + i * TERM_STRIDE);
  values[i] = skel_field(term.primitive, term.kernel, term.skel, points[i].xyz);
}
