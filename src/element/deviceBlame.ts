/** Which bodies of a picture that a graphics device refused it refuses by themselves: those are not asked of it again, the others are. */
import type { RayCamera } from '../field/rayImage.ts';
import type { GpuRaycaster, PlacedBody } from '../gpu/raycast/raycaster.ts';
import { taken } from '../gpu/taken.ts';
import { DeviceImages } from './deviceImages.ts';

/** pixels along a side of the picture that a body is asked for */
const SIDE = 16;

type Casts = Pick<GpuRaycaster, 'image' | 'cast'>;

/** For each body whether it is to blame. */
export const blamed = (
  device: GPUDevice,
  raycaster: Casts,
  bodies: readonly PlacedBody[],
  { view, offset }: RayCamera,
): Promise<readonly boolean[]> => {
  const small = { view, width: SIDE, height: SIDE, offset };
  return Promise.all(bodies.map((body) => refuses(device, raycaster, body, small)));
};

async function refuses(
  device: GPUDevice,
  raycaster: Casts,
  body: PlacedBody,
  camera: RayCamera,
): Promise<boolean> {
  const images = new DeviceImages(camera, []);
  try {
    const image = await taken(device, 'an image', () => images.begin(raycaster));
    const cast = taken(device, 'rays', () => raycaster.cast(image, [body], camera));
    return await cast.then(
      () => false,
      () => true,
    );
  } catch {
    // there is no room at all, which is no fault of the body
    return false;
  } finally {
    images.drop();
  }
}
