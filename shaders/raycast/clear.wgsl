#import raycast/camera

// A picture with nothing in it. A thread is a pixel, those between the rows' ends included.

@group(0) @binding(2) var<storage, read_write> surface: array<vec4f>;
@group(0) @binding(3) var<storage, read_write> colours: array<vec4f>;

@compute @workgroup_size(8, 8)
fn clear_pixels(@builtin(global_invocation_id) id: vec3u) {
  if (id.x < camera.stride && id.y < camera.picture.y) {
    surface[id.x + camera.stride * id.y] = vec4f(0.0, 0.0, 0.0, NOWHERE);
    colours[id.x + camera.stride * id.y] = vec4f(0.0);
  }
}
