// The pages of the reference as Markdown.

const kinds = { class: 'Classes', function: 'Functions', constant: 'Constants', type: 'Types' };

/** Files of the reference by name: the pages, each of which begins with what is on it, and a list of them. */
export function renderReference(pages) {
  const anchors = pages.map((page) => new Anchors(page));
  const files = pages.map((page, i) => {
    const elsewhere = anchors.filter((other) => other !== anchors[i]);
    return [page.file, renderPage(page, new Links(anchors[i], elsewhere))];
  });
  return new Map([...files, ['README.md', renderIndex(pages)]]);
}

function renderPage({ title, about, items }, links) {
  const ofKind = (kind) => items.filter((item) => item.kind === kind);
  const namesOf = (kind) => ofKind(kind).map(({ name }) => links.to(name, name));
  const [classes, ...others] = Object.keys(kinds);
  const paragraphs = [
    `# ${title}`,
    about,
    `${note} [All pages](README.md).`,
    ...ofKind(classes).map((item) => renderOverview(item, links)),
    ...others.map((kind) => listed(kinds[kind], namesOf(kind))),
    ...Object.keys(kinds)
      .flatMap(ofKind)
      .map((item) => renderItem(item, links)),
  ];
  return `${joined(paragraphs)}\n`;
}

function renderIndex(pages) {
  const rows = pages.map(({ file, title, entries, about }) => {
    const from = entries.map((entry) => `\`halfedge${entry.slice(1)}\``).join(', ');
    return `| [${title}](${file}) | ${from} | ${about} |`;
  });
  return `# Reference

Everything that the package exports. ${note} The docstrings show in editors, too.
The [guides](../../README.md#guides) tell how things belong together. [C++](../cpp.md) has the same names in \`snake_case\`.

| page | import from | what it has |
| --- | --- | --- |
${rows.join('\n')}
`;
}

const note = '`npm run reference` writes this page from the docstrings.';

// ---- parts of a page ------------------------------------------------------------------------

/** A class, and its members part by part; of an operation, not its check as well. */
function renderOverview({ name, parts }, links) {
  const lines = parts.map(({ title, members }) => {
    const names = new Set(members.map((member) => member.name.toLowerCase()));
    const isCheck = (member) =>
      member.name.startsWith('check') && names.has(member.name.slice('check'.length).toLowerCase());
    const shown = members.filter((member) => !(isCheck(member) || isSilent(member)));
    return listed(
      title ? `- ${title}` : '',
      shown.map((member) => links.to(member, member.name)),
    );
  });
  // What the class has itself comes before the list of what it is made of.
  const own = parts[0]?.title ? '' : lines.shift();
  return joined([`**${links.to(name, name)}**`, own, lines.join('\n')]);
}

function listed(title, names) {
  if (names.length === 0) return '';
  return `${title === '' ? '' : `${title}: `}${names.join(' · ')}`;
}

function renderItem({ name, doc, code, overloads, extended, parts }, links) {
  const heading = `## ${name}`;
  if (overloads) return joined([heading, renderOverloads(overloads, links)]);
  if (!parts) return joined([heading, fenced(code), renderDoc(doc, links)]);
  const base = extended ? `Extends ${links.to(extended, extended)}.` : '';
  return joined([
    heading,
    renderDoc(doc, links),
    base,
    ...parts.map((part) => renderPart(part, links)),
  ]);
}

function renderPart({ title, doc, members }, links) {
  const heading = title ? [`### ${title}`, renderDoc(doc, links)] : [];
  const silent = members.filter(isSilent).flatMap(({ overloads }) => overloads);
  const code = silent.length > 0 ? fenced(silent.map(({ signature }) => signature).join('\n')) : '';
  const sections = members
    .filter((member) => !isSilent(member))
    .map(({ name, overloads }) => joined([`#### ${name}`, renderOverloads(overloads, links)]));
  return joined([...heading, code, ...sections]);
}

/** Whether the name of a member says it all: such ones stand together. */
const isSilent = ({ overloads }) => overloads.every(({ doc }) => isEmpty(doc));

/** Overloads with nothing to say of themselves stand below the one before them. */
function renderOverloads(overloads, links) {
  const blocks = [];
  for (const { signature, doc } of overloads) {
    if (isEmpty(doc) && blocks.length > 0) blocks.at(-1).code.push(signature);
    else blocks.push({ code: [signature], doc });
  }
  return joined(
    blocks.flatMap(({ code, doc }) => [fenced(code.join('\n')), renderDoc(doc, links)]),
  );
}

const fenced = (code) => `\`\`\`ts\n${code}\n\`\`\``;

const joined = (paragraphs) => paragraphs.filter((text) => text !== '').join('\n\n');

// ---- docstrings -----------------------------------------------------------------------------

const isEmpty = ({ text, params, throws, returns }) =>
  text === '' && params.length === 0 && throws.length === 0 && returns === '';

function renderDoc({ text, params, throws, returns }, links) {
  const items = [
    ...params.map((param) => `\`${param.name}\`: ${param.text}`),
    ...(returns === '' ? [] : [`returns ${returns}`]),
    ...throws.map((what) => `throws ${what}`),
  ];
  const list = items.map((item) => `- ${item.replaceAll('\n', '\n  ')}`).join('\n');
  return links.resolved(joined([text, list]));
}

// ---- links ----------------------------------------------------------------------------------

/** Where the headings of a page are, as GitHub names them: the second of a name ends in -1. */
class Anchors {
  #taken = new Map();
  #ofMember = new Map();
  #ofName = new Map();

  constructor({ file, title, items }) {
    this.file = file;
    this.#add(title);
    // In the order of the page: the number of a heading depends on those before it.
    const sorted = Object.keys(kinds).flatMap((kind) => items.filter((item) => item.kind === kind));
    for (const item of sorted) {
      this.#ofName.set(item.name, this.#add(item.name));
      for (const part of item.parts ?? []) {
        if (part.title) this.#ofName.set(part.name, this.#add(part.title));
        for (const member of part.members) {
          if (!isSilent(member)) this.#addMember(member, item.name);
        }
      }
    }
  }

  /** The anchor of a member, or of what has this name: an item, a part, `member` or `Item.member`. */
  find(target) {
    return this.#ofMember.get(target) ?? this.#ofName.get(target);
  }

  #addMember(member, className) {
    const anchor = this.#add(member.name);
    this.#ofMember.set(member, anchor);
    const name = member.name.slice(member.name.lastIndexOf('.') + 1);
    this.#ofName.set(`${className}.${name}`, anchor);
    if (!this.#ofName.has(name)) this.#ofName.set(name, anchor);
  }

  #add(heading) {
    const slug = heading
      .toLowerCase()
      .replaceAll(/[^\w\- ]/g, '')
      .replaceAll(' ', '-');
    const before = this.#taken.get(slug) ?? 0;
    this.#taken.set(slug, before + 1);
    return before === 0 ? slug : `${slug}-${before}`;
  }
}

/** The links of one page, also to the others. */
class Links {
  constructor(here, elsewhere) {
    this.here = here;
    this.elsewhere = elsewhere;
  }

  /** A link to a member of the page, or to what has this name; code where nothing has it. */
  to(target, text) {
    const anchor = this.here.find(target);
    if (anchor !== undefined) return `[\`${text}\`](#${anchor})`;
    const other = this.elsewhere.find((page) => page.find(target) !== undefined);
    return other ? `[\`${text}\`](${other.file}#${other.find(target)})` : `\`${text}\``;
  }

  /** Markdown in which `{@link name}` is a link. */
  resolved(markdown) {
    return markdown.replaceAll(/\{@link ([\w.]+)\}/g, (_, name) => this.to(name, name));
  }
}
