/** The drawings to look at: a list beside them says their names; it is fetched once, and each drawing when it is chosen. */

export interface Sample {
  readonly name: string;
  readonly strokes: number;
  /** of bodies */
  readonly skels: number;
  /** addresses */
  readonly file: string;
  readonly thumbnail: string;
}

export class Samples {
  list: readonly Sample[] = [];
  #address: string | null = null;
  readonly #changed: () => void;

  constructor(changed: () => void) {
    this.#changed = changed;
  }

  /** Of the list; null: there is none. The same one again does nothing. */
  async show(address: string | null): Promise<void> {
    if (address === this.#address) return;
    this.#address = address;
    const list = address === null ? [] : await fetchList(address).catch(() => []);
    // Without samples there is still the pen: nobody has to hear of it.
    if (this.#address !== address) return;
    this.list = list;
    this.#changed();
  }
}

async function fetchList(written: string): Promise<Sample[]> {
  const address = new URL(written, document.baseURI);
  const answer = await fetch(address);
  const entries: unknown = answer.ok ? await answer.json() : [];
  const resolve = (path: string) => new URL(path, address).href;
  return (Array.isArray(entries) ? entries : [])
    .filter(isSample)
    .map(({ file, thumbnail, name, strokes, skels = 0 }) => ({
      name,
      strokes,
      skels,
      file: resolve(file),
      thumbnail: resolve(thumbnail),
    }));
}

type Entry = Omit<Sample, 'skels'> & Partial<Pick<Sample, 'skels'>>;

const isSample = (entry: Partial<Sample> | null): entry is Entry =>
  typeof entry?.name === 'string' &&
  typeof entry.file === 'string' &&
  typeof entry.thumbnail === 'string' &&
  typeof entry.strokes === 'number' &&
  ['number', 'undefined'].includes(typeof entry.skels);

export async function fetchSample({ file, name }: Sample): Promise<string> {
  const answer = await fetch(file).catch(() => null);
  if (!answer?.ok) throw new Error(`${name} could not be fetched.`);
  return answer.text();
}
