// What the element offers, from the words in its source: the custom elements manifest of the package, and the tables of
// docs/element.md. `node scripts/manifest.mjs` writes the tables; with --check it only says whether they are stale.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { pathToFileURL } from 'node:url';
import { create, ts } from '@custom-elements-manifest/analyzer';
import { litPlugin } from '@custom-elements-manifest/analyzer/src/features/framework-plugins/lit/lit.js';

const SOURCES = ['src/element/api.ts', 'src/element/rotundSketch.ts'];
const DOCS = 'docs/element.md';
const NAME = 'RotundSketch';
const TAG = 'rotund-sketch';

/** What Lit and the platform call, and what says nothing to a page. */
const OURS =
  /^(#|_|constructor$|styles$|properties$|render$|updated$|willUpdate$|firstUpdated$|.*Callback$|addEventListener$)/;

/** One class as pages see it, whatever files it is written in. */
function declaration() {
  const modules = SOURCES.map((path) =>
    ts.createSourceFile(path, readFileSync(path, 'utf8'), ts.ScriptTarget.ES2022, true),
  );
  const found = create({ modules, plugins: litPlugin(), context: { dev: false } });
  const all = found.modules.flatMap(({ declarations }) => declarations);
  const element = all.find(({ name }) => name === NAME);
  const clean = ({ inheritedFrom, parameters, ...entry }) => ({
    ...entry,
    ...(entry.description && { description: oneLine(entry.description) }),
    ...(parameters && { parameters }),
  });
  const isPublic = ({ name, privacy, description, static: isStatic }) =>
    !isStatic && (privacy ?? 'public') === 'public' && !OURS.test(name) && description;
  const members = apiFirst(element.members).filter(isPublic).map(clean);
  const fields = new Set(members.map(({ name }) => name));
  return {
    kind: 'class',
    name: NAME,
    tagName: TAG,
    customElement: true,
    superclass: { name: 'LitElement', package: 'lit' },
    attributes: apiFirst(element.attributes)
      .filter(({ fieldName }) => fields.has(fieldName))
      .map(clean),
    members,
    // The first mention of an event is the one with words.
    events: element.events.filter(({ description }) => description).map(clean),
    slots: element.slots.map(clean),
    cssParts: element.cssParts.map(clean),
    cssProperties: element.cssProperties.map(clean),
  };
}

/** What is said to the page before what is said to the application. */
const apiFirst = (entries) => [
  ...entries.filter(({ inheritedFrom }) => inheritedFrom),
  ...entries.filter(({ inheritedFrom }) => !inheritedFrom),
];

const oneLine = (text) => text.replace(/\s+/g, ' ').trim();

const ENTRY = 'dist/lib/rotund.js';
const DEFINE = 'dist/lib/define.js';

export function manifest() {
  return {
    schemaVersion: '2.1.0',
    readme: DOCS,
    modules: [
      {
        kind: 'javascript-module',
        path: ENTRY,
        declarations: [declaration()],
        exports: [{ kind: 'js', name: NAME, declaration: { name: NAME, module: ENTRY } }],
      },
      {
        kind: 'javascript-module',
        path: DEFINE,
        declarations: [],
        exports: [
          { kind: 'custom-element-definition', name: TAG, declaration: { name: NAME, module: ENTRY } },
        ],
      },
    ],
  };
}

export function writeManifest(path) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, `${JSON.stringify(manifest(), null, 2)}\n`);
}

// ── the tables ──────────────────────────────────────────────────────────────────────────────────────────

const cell = (text) => oneLine(text ?? '').replaceAll('|', '\\|');
const code = (text) => `\`${cell(text)}\``;

function table(head, rows) {
  const line = (cells) => `| ${cells.join(' | ')} |`;
  return [line(head), `|${'---|'.repeat(head.length)}`, ...rows.map(line)].join('\n');
}

function signature({ name, parameters = [], return: result }) {
  const named = parameters.map((p) => {
    const type = p.type?.text ?? 'object';
    // A pattern has no name of its own.
    const plain = /^\w+$/.test(p.name) ? p.name : 'options';
    return `${plain}${p.optional || p.default ? '?' : ''}: ${type}`;
  });
  return `${name}(${named.join(', ')})${result?.type ? `: ${result.type.text}` : ''}`;
}

const attributeOf = ({ attribute, type }) => (type?.text === 'boolean' ? attribute : `${attribute}="…"`);

function tables({ members, events, slots, cssParts, cssProperties }) {
  const fields = members.filter(({ kind }) => kind === 'field');
  const reflected = fields.filter(({ attribute }) => attribute);
  const plain = fields.filter(({ attribute }) => !attribute);
  const named = (entries) => entries.map(({ name, description }) => [code(name), cell(description)]);
  return {
    attributes: table(
      ['attribute', 'property', 'type', 'meaning'],
      reflected.map((f) => [code(attributeOf(f)), code(f.name), code(f.type.text), cell(f.description)]),
    ),
    properties: table(
      ['property', 'type', 'meaning'],
      plain.map((f) => [
        code(f.name),
        code(f.type?.text),
        `${cell(f.description)}${f.readonly ? ' Read only.' : ''}`,
      ]),
    ),
    methods: table(
      ['method', 'does'],
      members.filter(({ kind }) => kind === 'method').map((m) => [code(signature(m)), cell(m.description)]),
    ),
    events: table(
      ['event', 'type', 'when'],
      events.map(({ name, type, description }) => [code(name), code(type.text), cell(description)]),
    ),
    slots: table(['slot', 'what'], named(slots)),
    parts: table(['part', 'what'], named(cssParts)),
    'custom properties': table(['property', 'what'], named(cssProperties)),
  };
}

/** The page with its tables made anew: each stands between `<!-- name -->` and `<!-- /name -->`. */
function written(page) {
  const made = tables(declaration());
  return page.replace(/<!-- ([\w ]+) -->[\s\S]*?<!-- \/\1 -->/g, (whole, name) =>
    made[name] ? `<!-- ${name} -->\n${made[name]}\n<!-- /${name} -->` : whole,
  );
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const page = readFileSync(DOCS, 'utf8');
  const fresh = written(page);
  if (!process.argv.includes('--check')) writeFileSync(DOCS, fresh);
  else if (fresh !== page) {
    console.error(`${DOCS} is stale: node scripts/manifest.mjs writes it anew.`);
    process.exit(1);
  }
}
