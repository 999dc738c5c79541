// The public declarations of the package, as data: what each entry exports, with signatures and docstrings.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript-oldest'; // the compiler as a library, which later versions aren't
import { Failure } from '../lib/run.mjs';
import { entriesWithoutPage, parts } from './pages.mjs';

/**
 * Reads what the pages show. Each gets `items`: `{ name, kind, doc, signatures }` for a function or a constant,
 * `{ name, kind, doc, code }` for an interface or a type, `{ name, kind, doc, extended, parts }` for a class. A part is
 * `{ title, name, doc, members }`, and a member `{ name, overloads }`, each with `signature` and `doc`.
 *
 * A `doc` is `{ text, params, throws, returns }`. Throws a Failure if an exported item has no docstring, or an entry of
 * the package no page.
 */
export function readPages(root, pages) {
  const { exports } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const typesOf = (entry) => join(root, exports[entry].types);
  const shown = pages.flatMap((page) => page.entries);
  const left = Object.keys(exports).filter(
    (entry) => exports[entry].types?.endsWith('.d.ts') && !shown.includes(entry),
  );
  const forgotten = left.filter((entry) => !entriesWithoutPage.includes(entry));
  if (forgotten.length > 0)
    throw new Failure(`No page shows what ${forgotten.join(', ')} exports.`);

  const program = ts.createProgram(shown.map(typesOf), {
    target: ts.ScriptTarget.ESNext,
    module: ts.ModuleKind.NodeNext,
    moduleResolution: ts.ModuleResolutionKind.NodeNext,
    skipLibCheck: true,
  });
  const reader = new Reader(program.getTypeChecker(), join(root, 'dist'));
  const named = pages.flatMap(({ names }) => names ?? []);
  const read = pages.map((page) => {
    const files = page.entries.map((entry) => program.getSourceFile(typesOf(entry)));
    const items = reader.exportsOf(files);
    const isHere = ({ name }) => page.names?.includes(name) ?? !named.includes(name);
    return { ...page, items: items.filter(isHere) };
  });
  const silent = read.flatMap(undocumented);
  if (silent.length > 0) throw new Failure(`These have no docstring: ${silent.join(', ')}.`);
  return read;
}

/** What has no docstring on a page. An overload is documented by the one before it, a constructor by its class. */
function undocumented({ items, namesSayIt }) {
  const silent = items.filter(({ doc }) => doc.text === '').map(({ name }) => name);
  if (namesSayIt) return silent;
  const parts = items.flatMap((item) =>
    (item.parts ?? []).map((part) => ({ ...part, of: item.name })),
  );
  const members = parts.flatMap((part) =>
    part.members
      .filter(({ name, overloads: [{ doc }] }) => doc.text === '' && !name.startsWith('new '))
      .map(({ name }) => `${name} of ${part.of}`),
  );
  return [...silent, ...members];
}

class Reader {
  constructor(checker, dist) {
    this.checker = checker;
    this.dist = dist;
  }

  /** What these files export, each item once, in the order of the files that declare them. */
  exportsOf(files) {
    const symbols = files.flatMap((file) =>
      this.checker.getExportsOfModule(this.checker.getSymbolAtLocation(file)),
    );
    const originals = symbols.map((symbol) =>
      symbol.flags & ts.SymbolFlags.Alias ? this.checker.getAliasedSymbol(symbol) : symbol,
    );
    return [...new Set(originals)].map((symbol) => this.#itemOf(symbol));
  }

  #itemOf(symbol) {
    const declarations = symbol.declarations.filter((node) => this.#isOurs(node));
    const [first] = declarations;
    return { name: symbol.name, doc: docOf(first), ...this.#contentOf(first, declarations) };
  }

  #contentOf(first, declarations) {
    if (ts.isClassDeclaration(first)) return this.#classOf(first);
    if (ts.isFunctionDeclaration(first)) {
      const overloads = declarations.map((node) => ({ signature: codeOf(node), doc: docOf(node) }));
      return { kind: 'function', overloads };
    }
    if (ts.isVariableDeclaration(first)) {
      return { kind: 'constant', code: `const ${withoutComments(first)}` };
    }
    return { kind: 'type', code: declarations.map(codeOf).join('\n') };
  }

  #classOf(node) {
    const chain = this.#chainOf(node);
    const [own, ...inherited] = chain.filter((ancestor) => this.#isOurs(ancestor));
    const theirs = chain.find((ancestor) => !this.#isOurs(ancestor));
    const theirNames = new Set(theirs && this.#membersOf(theirs, node.name.text));
    const partOf = (ancestor) => this.#partOf(ancestor, node.name.text, theirNames);
    return {
      kind: 'class',
      extended: theirs?.name.text,
      parts: [partOf(own), ...inherited.reverse().map(partOf)].filter(
        ({ members }) => members.length > 0,
      ),
    };
  }

  /** The names of what a class of another package has, as they would be if `className` were its name. */
  #membersOf(node, className) {
    const type = this.checker.getTypeOfSymbol(this.checker.getSymbolAtLocation(node.name));
    const ofInstances = this.checker.getTypeAtLocation(node).getProperties();
    const ofClass = type.getProperties().map(({ name }) => `${className}.${name}`);
    return [...ofClass, ...ofInstances.map(({ name }) => name)];
  }

  /** A class and those that it extends, up to one of another package. */
  #chainOf(node) {
    const chain = [];
    for (let ancestor = node; ancestor; ) {
      chain.push(ancestor);
      if (!this.#isOurs(ancestor)) break;
      const clause = ancestor.heritageClauses?.find(
        ({ token }) => token === ts.SyntaxKind.ExtendsKeyword,
      );
      const symbol = clause && this.checker.getTypeAtLocation(clause.types[0]).symbol;
      ancestor = symbol?.declarations.find(
        (one) => ts.isClassDeclaration(one) || ts.isInterfaceDeclaration(one),
      );
    }
    return chain;
  }

  /** What one class of a chain declares. What is usual is left out where it has no docstring, as overrides are. */
  #partOf(node, className, theirNames) {
    const isOwn = node.name.text === className;
    const title = isOwn ? undefined : parts[node.name.text];
    if (!(isOwn || title))
      throw new Failure(`scripts/reference/pages.mjs has no title for ${node.name.text}.`);
    const members = new Map();
    for (const member of node.members.filter(isPublic)) {
      const name = nameOf(member, className);
      const overload = { signature: memberCodeOf(member, className), doc: docOf(member) };
      const isPlain = ts.isConstructorDeclaration(member) && member.parameters.length === 0;
      const isUsual = isPlain || name.startsWith('[Symbol.') || theirNames.has(name);
      if (isUsual && overload.doc.text === '') continue;
      if (!members.has(name)) members.set(name, { name, overloads: [] });
      // A setter says nothing that its getter doesn't.
      if (ts.isSetAccessor(member)) continue;
      members.get(name).overloads.push(overload);
    }
    return {
      title,
      name: node.name.text,
      doc: docOf(node),
      members: [...members.values()].filter(({ overloads }) => overloads.length > 0),
    };
  }

  #isOurs(node) {
    return node.getSourceFile().fileName.startsWith(this.dist);
  }
}

function isPublic(member) {
  const hidden = [ts.SyntaxKind.PrivateKeyword, ts.SyntaxKind.ProtectedKeyword];
  if (member.modifiers?.some(({ kind }) => hidden.includes(kind))) return false;
  return (
    !(member.name && ts.isPrivateIdentifier(member.name)) && !ts.isIndexSignatureDeclaration(member)
  );
}

const isStatic = (member) =>
  member.modifiers?.some(({ kind }) => kind === ts.SyntaxKind.StaticKeyword);

function nameOf(member, className) {
  if (ts.isConstructorDeclaration(member)) return `new ${className}`;
  const name = withSymbol(member.name.getText());
  return isStatic(member) ? `${className}.${name}` : name;
}

/** A mesh has `Symbol.dispose` under a name of its own, since it may have to stand in for it. */
const withSymbol = (code) => code.replace('[disposeSymbol]', '[Symbol.dispose]');

/** How a member is used: `new X(…)`, `X.of(…)` for static ones, an accessor as a property. */
function memberCodeOf(member, className) {
  const code = withSymbol(codeOf(member));
  if (ts.isConstructorDeclaration(member)) return code.replace('constructor', `new ${className}`);
  if (ts.isGetAccessor(member)) {
    const hasSetter = member.parent.members.some(
      (other) => ts.isSetAccessor(other) && other.name.getText() === member.name.getText(),
    );
    return code.replace('get ', hasSetter ? '' : 'readonly ').replace('()', '');
  }
  return isStatic(member) ? code.replace('static ', `${className}.`) : code;
}

/** A declaration without its own docstring; the comments within it stay. A long list of parameters is broken. */
function codeOf(node) {
  const file = node.getSourceFile();
  const start = node.getStart();
  let code = node.getText();
  if (code.search(/\n|$/) > 110 && node.parameters?.length > 0) {
    const { pos, end } = node.parameters;
    const parameters = node.parameters.map((parameter) => `\n  ${parameter.getText()},`);
    code = `${code.slice(0, pos - start)}${parameters.join('')}\n${code.slice(end - start)}`;
  }
  const { character: column } = file.getLineAndCharacterOfPosition(start);
  return code
    .replace(/^(export |declare |abstract |default )+/, '')
    .replaceAll(/\{@link ([\w.]+)\}/g, '`$1`')
    .replaceAll(new RegExp(`\\n {${column}}`, 'g'), '\n')
    .replaceAll(/^( {4})+/gm, (indent) => ' '.repeat(indent.length / 2))
    .replace(/;$/, '');
}

const withoutComments = (node) => node.getText().replace(/\/\*\*.*?\*\/\s*/gs, '');

/** The docstring of a declaration, its tags apart. */
function docOf(node) {
  const commented = ts.isVariableDeclaration(node) ? node.parent.parent : node;
  const doc = { text: '', params: [], throws: [], returns: '' };
  for (const comment of ts.getJSDocCommentsAndTags(commented).filter(ts.isJSDoc)) {
    doc.text = textOf(comment.comment);
    for (const tag of comment.tags ?? []) {
      const text = textOf(tag.comment);
      if (ts.isJSDocParameterTag(tag)) doc.params.push({ name: tag.name.getText(), text });
      else if (ts.isJSDocReturnTag(tag)) doc.returns = text;
      else if (ts.isJSDocThrowsTag(tag)) doc.throws.push(textOf(tag.comment));
      else throw new Failure(`The reference knows nothing of @${tag.tagName.text}.`);
    }
  }
  return doc;
}

/** A comment as Markdown, in which links are still `{@link name}`. */
function textOf(comment) {
  if (comment === undefined) return '';
  if (typeof comment === 'string') return comment.trim();
  const texts = comment.map((part) =>
    ts.isJSDocLink(part) ? `{@link ${part.name?.getText()}}${part.text}` : part.text,
  );
  return texts.join('').trim();
}
