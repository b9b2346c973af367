// Start-up self-test: a compute pass and a draw whose results are known beforehand.

@group(0) @binding(0) var<storage, read_write> numbers: array<f32>;

var<workgroup> shared_numbers: array<f32, 64>;

// numbers[i] = i² + ½ of the mirrored thread, so that workgroup memory and the barrier take part
@compute @workgroup_size(64)
fn compute_numbers(@builtin(local_invocation_index) i: u32) {
  let x = f32(i);
  shared_numbers[i] = x * x + 0.5;
  workgroupBarrier();
  numbers[i] = shared_numbers[63u - i];
}

@vertex
fn cover(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
  return vec4f(f32(i & 1u) * 4.0 - 1.0, f32(i >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

// each pixel tells where it is: red = 16 x, green = 16 y, in 1/255
@fragment
fn colour_by_place(@builtin(position) place: vec4f) -> @location(0) vec4f {
  return vec4f(floor(place.xy) * 16.0 / 255.0, 128.0 / 255.0, 1.0);
}
