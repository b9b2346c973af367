/**
 * The field page: one element that fills it. `?backend=webgl2` shows it as on a machine without WebGPU; `?rays=device` has the graphics device
 * cast rays whatever it is, `?rays=worker` workers.
 */
import './element/field/define.ts';

const field = document.querySelector('rotund-field');
const query = new URLSearchParams(location.search);
if (field && query.get('backend') === 'webgl2') field.backend = 'webgl2';
const rays = query.get('rays');
if (field && (rays === 'device' || rays === 'worker')) field.stage.rays.choice = rays;
