/** What is asked of skels, in values of one skel at one point: how work is counted wherever it is. */

/** value and gradient */
export const WITH_GRADIENT = 1.6;
/** a distance, or a bound that needs no evaluation */
export const TEST = 0.25;
/** one source of a skel that is replaced by points */
export const POINT = 0.45;
/** additions and products that come to one value */
export const FLOPS = 80;
