/** Where a browser keeps drawings: IndexedDB, a record a slot. A write that follows nobody else's is the only one that counts. */
import { type IDBPDatabase, openDB } from 'idb';

/** `current` is the drawing at work; what it replaced, and what could not be read, lie beside it. */
export type Slot = 'current' | 'previous' | 'unreadable';

export interface Stored {
  /** of a `.rotund` file */
  readonly text: string;
  readonly name: string;
  /** ms since 1970 */
  readonly time: number;
  /** counts writes: another number than one's own last one means that another page writes, too */
  readonly revision: number;
  /** a person chose the paper: the theme leaves it alone */
  readonly ownPaper: boolean;
  /** the file that has the very same, and the way back to it */
  readonly file: StoredFile | null;
}

export interface StoredFile {
  readonly name: string;
  readonly unchanged: boolean;
  readonly handle?: FileSystemFileHandle;
}

/** Another page has written since. */
export class Superseded extends Error {}

export interface Vault {
  read(slot: Slot): Promise<Stored | null>;
  /** `after`: only when the record there still has this revision, else Superseded; without it, whatever is there. */
  write(slot: Slot, stored: Stored, after?: number): Promise<void>;
  remove(slot: Slot): Promise<void>;
  close(): void;
}

const STORE = 'drawings';

/** A vault a key; nothing is opened before the first use. */
export function createVault(key: string): Vault {
  const place = (slot: Slot) => `${key}/${slot}`;
  let opened: Promise<IDBPDatabase> | null = null;
  const forget = () => {
    opened = null;
  };
  const database = () => {
    opened ??= openDB('rotund', 1, {
      upgrade: (db) => void db.createObjectStore(STORE),
      blocking: () =>
        void opened
          ?.then((db) => db.close())
          .catch(forget)
          .finally(forget),
      terminated: forget,
    });
    opened.catch(forget);
    return opened;
  };
  return {
    read: async (slot) => (await (await database()).get(STORE, place(slot))) ?? null,
    async write(slot, stored, after) {
      const transaction = (await database()).transaction(STORE, 'readwrite');
      const ended = transaction.done;
      ended.catch(() => {});
      if (after !== undefined) {
        const there: Stored | undefined = await transaction.store.get(place(slot));
        if (there && there.revision !== after) throw new Superseded();
      }
      void transaction.store.put(stored, place(slot)).catch(() => {});
      // At once: a page that is about to go does not wait for answers.
      transaction.commit();
      await ended;
    },
    remove: async (slot) => (await database()).delete(STORE, place(slot)),
    close: () =>
      void opened
        ?.then((db) => db.close())
        .catch(forget)
        .finally(forget),
  };
}
