/**
 * The application: one element that fills the page. `?backend=webgl2` shows it as on a machine without WebGPU,
 * `?quality=fine` as for a picture. `?rays=device` has the graphics device cast rays whatever it is, `?rays=worker` workers.
 */
import './element/define.ts';

const sketch = document.querySelector('rotund-sketch');
const query = new URLSearchParams(location.search);
if (sketch && query.get('backend') === 'webgl2') sketch.backend = 'webgl2';
if (sketch && query.get('quality') === 'fine') sketch.quality = 'fine';
const rays = query.get('rays');
if (sketch && (rays === 'device' || rays === 'worker')) sketch.session.rays.choice = rays;

const { title } = document;
sketch?.addEventListener('rename', ({ detail: { name } }) => {
  document.title = name ? `${name} – ${title}` : title;
});
