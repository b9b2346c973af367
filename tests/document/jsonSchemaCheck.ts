/** A judge of JSON Schemas that knows the keywords of ours and no others: a keyword it does not know is an error. */

type Schema = Readonly<Record<string, unknown>>;

const SILENT = ['$schema', '$defs', 'title', 'description', 'default'];

type Judge = (argument: never, value: unknown, schema: Schema, root: Schema) => boolean;

const isObject = (value: unknown): value is Schema =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const typeOf = (value: unknown): string =>
  value === null ? 'null' : Array.isArray(value) ? 'array' : typeof value;

const numbers = (rule: (value: number, limit: number) => boolean) => (limit: number, value: unknown) =>
  typeof value !== 'number' || rule(value, limit);
const lengths = (rule: (value: number, limit: number) => boolean) => (limit: number, value: unknown) =>
  typeof value !== 'string' || rule([...value].length, limit);
const sizes = (rule: (value: number, limit: number) => boolean) => (limit: number, value: unknown) =>
  !Array.isArray(value) || rule(value.length, limit);
const atLeast = (value: number, limit: number) => value >= limit;
const atMost = (value: number, limit: number) => value <= limit;

const KEYWORDS: Readonly<Record<string, Judge>> = {
  $ref: (ref: string, value, _schema, root) => accepts(definition(root, ref), value, root),
  type: (type: string, value) => (type === 'integer' ? Number.isInteger(value) : type === typeOf(value)),
  const: (wanted: unknown, value) => value === wanted,
  enum: (options: readonly unknown[], value) => options.includes(value),
  anyOf: (options: readonly Schema[], value, _schema, root) =>
    options.some((option) => accepts(option, value, root)),
  oneOf: (options: readonly Schema[], value, _schema, root) =>
    options.filter((option) => accepts(option, value, root)).length === 1,
  minimum: numbers(atLeast),
  maximum: numbers(atMost),
  minLength: lengths(atLeast),
  maxLength: lengths(atMost),
  minItems: sizes(atLeast),
  maxItems: sizes(atMost),
  pattern: (pattern: string, value) => typeof value !== 'string' || new RegExp(pattern, 'u').test(value),
  required: (keys: readonly string[], value) =>
    !isObject(value) || keys.every((key) => Object.hasOwn(value, key)),
  properties: (properties: Readonly<Record<string, Schema>>, value, _schema, root) =>
    !isObject(value) ||
    Object.keys(properties).every(
      (key) => !Object.hasOwn(value, key) || accepts(properties[key]!, value[key], root),
    ),
  additionalProperties: (allowed: false, value, { properties }) =>
    allowed !== false ||
    !isObject(value) ||
    Object.keys(value).every((key) => Object.hasOwn(properties as object, key)),
  prefixItems: (items: readonly Schema[], value, _schema, root) =>
    !Array.isArray(value) || items.every((item, i) => i >= value.length || accepts(item, value[i], root)),
  items: (items: Schema | false, value, { prefixItems = [] }, root) => {
    if (!Array.isArray(value)) return true;
    const rest = value.slice((prefixItems as readonly unknown[]).length);
    return items === false ? rest.length === 0 : rest.every((item) => accepts(items, item, root));
  },
};

export function accepts(schema: Schema, value: unknown, root: Schema = schema): boolean {
  return Object.entries(schema).every(([keyword, argument]) => {
    if (SILENT.includes(keyword)) return true;
    const judge = KEYWORDS[keyword];
    if (!judge) throw new Error(`unknown keyword ${keyword}`);
    return judge(argument as never, value, schema, root);
  });
}

function definition(root: Schema, ref: string): Schema {
  const found = (root.$defs as Readonly<Record<string, Schema>>)[ref.replace('#/$defs/', '')];
  if (!found) throw new Error(`no ${ref}`);
  return found;
}
