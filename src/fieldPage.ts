/** The field page: one element that fills it. `?backend=webgl2` shows it as on a machine without WebGPU. */
import './element/field/define.ts';

const field = document.querySelector('rotund-field');
if (field && new URLSearchParams(location.search).get('backend') === 'webgl2') field.backend = 'webgl2';
