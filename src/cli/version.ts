/** What the bundler knows of the package. */
declare const ROTUND_VERSION: string;
declare const ROTUND_PLAYWRIGHT: string;

export const VERSION = ROTUND_VERSION;
/** the version of playwright-core that goes with it */
export const PLAYWRIGHT = ROTUND_PLAYWRIGHT;
