#import record/rayCamera

// Rays through pixels. Twin of rayAt in src/stroke/plane.ts.

@group(0) @binding(9) var<uniform> camera: RayCamera;

// as in src/field/rayImage.ts
const NOWHERE = -0x1p100;

struct PixelRay {
  start: vec3f,
  along: vec3f,
  // mm: of a pixel where it starts, and more a mm along it
  pixel: f32,
  growth: f32,
  // mm along it: what is before that is behind the eye
  nearest: f32,
}

fn pixel_ray(x: u32, y: u32) -> PixelRay {
  let middle = 0.5 * vec2f(camera.picture.xy);
  let at = (vec2f(f32(x), f32(y)) + camera.offset - middle) * camera.pixel;
  let across = at.x * camera.right - at.y * camera.up;
  if (camera.distance == 0.0) {
    return PixelRay(camera.pivot + across, -camera.back, camera.pixel, 0.0, -3e38);
  }
  let to = across - camera.distance * camera.back;
  let eye = camera.pivot + camera.distance * camera.back;
  return PixelRay(eye, normalize(to), 0.0, camera.pixel / camera.distance, 0.0);
}
