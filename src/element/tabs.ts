/** Pages of one origin that keep the same drawing talk to each other, so that only one of them writes. */

export type TabMessage =
  /** who is there? */
  | { readonly type: 'hello' }
  /** it is kept here, since then; the older one goes on */
  | { readonly type: 'mine'; readonly since: number; readonly id: string }
  /** give it to me */
  | { readonly type: 'take' }
  /** all is written, it is yours */
  | { readonly type: 'given' };

export interface Tabs {
  post(message: TabMessage): void;
  close(): void;
}

export type OpenTabs = (receive: (message: TabMessage) => void) => Tabs;

/** Nobody to talk to: revisions in the vault still keep pages from overwriting each other. */
const ALONE: Tabs = { post: () => {}, close: () => {} };

export const tabsOf =
  (key: string): OpenTabs =>
  (receive) => {
    if (typeof BroadcastChannel === 'undefined') return ALONE;
    const channel = new BroadcastChannel(`rotund/${key}`);
    channel.addEventListener('message', ({ data }: MessageEvent<TabMessage>) => receive(data));
    return { post: (message) => channel.postMessage(message), close: () => channel.close() };
  };
