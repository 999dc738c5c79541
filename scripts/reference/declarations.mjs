// The public declarations of the package, as data: what each entry exports, with signatures and docstrings.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript-oldest'; // the compiler as a library, which later versions aren't
import { Failure } from '../lib/run.mjs';
import { entriesWithoutPage, parts } from './pages.mjs';

/**
 * Reads what the pages show. Each gets `items`: `{ name, kind, doc, overloads }` for a function, `{ name, kind, doc, code }` for a
 * constant or a type, `{ name, kind, doc, extended, parts }` for a class. A part is `{ title, name, doc, members }`, a
 * member `{ name, overloads }`, and an overload `{ signature, doc }`.
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
    const exported = new Set(originals);
    return [...exported].map((symbol) => this.#itemOf(symbol, exported));
  }

  #itemOf(symbol, exported) {
    const declarations = symbol.declarations.filter((node) => this.#isOurs(node));
    const [first] = declarations;
    return {
      name: symbol.name,
      doc: docOf(first),
      ...this.#contentOf(first, declarations, exported),
    };
  }

  #contentOf(first, declarations, exported) {
    if (ts.isClassDeclaration(first)) return this.#classOf(first, exported);
    if (ts.isFunctionDeclaration(first)) {
      const overloads = declarations.map((node) => ({ signature: codeOf(node), doc: docOf(node) }));
      return { kind: 'function', overloads };
    }
    if (ts.isVariableDeclaration(first)) {
      const isText = first.initializer && ts.isStringLiteral(first.initializer);
      const typed = isText ? `${first.name.text}: string` : withoutComments(first);
      return { kind: 'constant', code: `const ${typed}` };
    }
    return { kind: 'type', code: declarations.map((node) => this.#typeCodeOf(node)).join('\n') };
  }

  /** The code of a type. One that is made of a constant, such as `(typeof NAMES)[number]`, is spelled out. */
  #typeCodeOf(node) {
    const isOfConstant =
      ts.isTypeAliasDeclaration(node) &&
      !node.typeParameters &&
      /\btypeof\b/.test(node.type.getText());
    if (!isOfConstant) return codeOf(node);
    const { InTypeAlias, NoTruncation, UseSingleQuotesForStringLiteralType } = ts.TypeFormatFlags;
    const flags = InTypeAlias | NoTruncation | UseSingleQuotesForStringLiteralType;
    const type = this.checker.getTypeAtLocation(node.name);
    return `type ${node.name.text} = ${this.checker.typeToString(type, node, flags)}`;
  }

  #classOf(node, exported) {
    const className = node.name.text;
    const { chain, end } = this.#chainOf(node, exported);
    const endNames = new Set(end && this.#membersOf(end, className));
    const [own, ...inherited] = chain.map((ancestor) => partOf(ancestor, className, endNames));
    const overridden = new Set(own.members.map(({ name }) => name));
    for (const part of inherited) {
      part.members = part.members.filter(({ name }) => !overridden.has(name));
      for (const { name } of part.members) overridden.add(name);
    }
    const shown = [own, ...inherited.reverse()].filter(({ members }) => members.length > 0);
    return { kind: 'class', extended: end?.name.text, parts: shown };
  }

  /** The names of what a class has, as they would be if `className` were its name. */
  #membersOf(node, className) {
    const type = this.checker.getTypeOfSymbol(this.checker.getSymbolAtLocation(node.name));
    const ofInstances = this.checker.getTypeAtLocation(node).getProperties();
    const ofClass = type.getProperties().map(({ name }) => `${className}.${name}`);
    return [...ofClass, ...ofInstances.map(({ name }) => name)];
  }

  /** A class and those that it extends, up to the `end`: one that the page shows, or of another package. */
  #chainOf(node, exported) {
    const chain = [node];
    for (;;) {
      const clause = chain
        .at(-1)
        .heritageClauses?.find(({ token }) => token === ts.SyntaxKind.ExtendsKeyword);
      if (clause === undefined) return { chain };
      const { symbol } = this.checker.getTypeAtLocation(clause.types[0]);
      const ancestor = symbol.declarations.find(
        (one) => ts.isClassDeclaration(one) || ts.isInterfaceDeclaration(one),
      );
      if (exported.has(symbol) || !this.#isOurs(ancestor)) return { chain, end: ancestor };
      chain.push(ancestor);
    }
  }

  #isOurs(node) {
    return node.getSourceFile().fileName.startsWith(this.dist);
  }
}

/** What one class of a chain declares. What is usual is left out where it has no docstring, as overrides are. */
function partOf(node, className, endNames) {
  const partName = node.name.text;
  const title = partName === className ? undefined : parts[partName];
  if (partName !== className && title === undefined) {
    throw new Failure(`scripts/reference/pages.mjs has no title for ${partName}.`);
  }
  const members = new Map();
  for (const member of node.members.filter(isPublic)) {
    const name = nameOf(member, className);
    const doc = docOf(member);
    const isPlain = ts.isConstructorDeclaration(member) && member.parameters.length === 0;
    const isUsual = isPlain || name.startsWith('[Symbol.') || endNames.has(name);
    // A setter says nothing that its getter doesn't.
    if (ts.isSetAccessor(member) || (isUsual && doc.text === '')) continue;
    if (!members.has(name)) members.set(name, { name, overloads: [] });
    members.get(name).overloads.push({ signature: memberCodeOf(member, className), doc });
  }
  return { title, name: partName, doc: docOf(node), members: [...members.values()] };
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
