export { finished } from '../../src/math/finished.ts';
