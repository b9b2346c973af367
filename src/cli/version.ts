/** What the bundler knows of the package. */
declare const ROTUND_VERSION: string;
declare const ROTUND_PLAYWRIGHT: string;
declare const ROTUND_WEBGPU: string;

export const VERSION = ROTUND_VERSION;
/** the version of playwright-core that goes with it */
export const PLAYWRIGHT = ROTUND_PLAYWRIGHT;
/** the version of webgpu that goes with it */
export const WEBGPU = ROTUND_WEBGPU;
