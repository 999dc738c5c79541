// The mutants of a C++ file: its statements deleted, its conditions negated, one at a time.
//
// This reads C++ as the project writes it, not all of C++: it divides the bodies of functions into
// statements by braces, parentheses and semicolons. What it takes for a statement and isn't makes a
// mutant that doesn't compile, which isn't counted.

/**
 * The mutants of `source`, in the order of the text. Each is
 * `{ kind, line, text, start, end, replacement }`: `source` from `start` to `end` becomes
 * `replacement`; `text` is the first line of the statement, `line` its number from 1 on.
 *
 * kind                what becomes of the statement
 * delete              a call or an assignment, `break` or `continue`: nothing
 * delete-refusal      `if (...) return ...;`: nothing, so that what it refuses is done
 * negate              the condition of an `if`, a loop or a `?:` is negated
 * negate-return       a returned condition is negated
 */
export function findMutants(source) {
  const code = blanked(source);
  const mutants = [];
  for (const statement of statements(code)) mutate(code, statement, mutants);
  mutants.sort((a, b) => a.start - b.start || a.end - b.end);
  return mutants.map((mutant) => ({ ...mutant, ...place(source, mutant.at) }));
}

export const applied = (source, { start, end, replacement }) =>
  source.slice(0, start) + replacement + source.slice(end);

function place(source, at) {
  const line = source.slice(0, at).split('\n').length;
  const end = source.indexOf('\n', at);
  return { line, text: source.slice(at, end < 0 ? source.length : end).trim() };
}

/** The source with spaces in place of comments, of strings and of preprocessor lines. */
function blanked(source) {
  const spaces = (text) => text.replace(/[^\n]/g, ' ');
  return source
    .replace(/\/\/[^\n]*|\/\*[\s\S]*?\*\/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'/g, (found) =>
      found[0] === '/' ? spaces(found) : found[0] + spaces(found.slice(2)) + found[0],
    )
    .replace(/^[ \t]*#(?:\\\n|[^\n])*/gm, spaces);
}

/** What a `{` after `head`, the statement so far, opens. */
function opens(head, isInCode) {
  if (/\b(?:namespace|class|struct|union|extern)\b[^()=]*$/.test(head)) return 'scope';
  if (/\b(?:enum|concept|requires)\b[^;]*$/.test(head)) return 'list';
  if (/(?:\)|\belse|\bdo|\bconst|\bnoexcept|\boverride|\bmutable)\s*$/.test(head)) return 'code';
  if (/\]\s*$/.test(head) && /[=(,]\s*\[[^[\]]*\]\s*$/.test(head)) return 'code'; // a lambda
  if (/\)\s*(?:const\s*)?->\s*[\w:<>*&\s]+$/.test(head)) return 'code';
  return isInCode && /^\s*(?:case\b[^?]*:|default\s*:)?\s*$/.test(head) ? 'code' : 'list';
}

/** The statements of all bodies of functions, as `[start, end]`; those that hold others as well. */
function statements(code) {
  const found = [];
  const stack = [{ kind: 'scope', start: 0, depth: 0 }];
  for (let i = 0; i < code.length; ++i) {
    const at = stack[stack.length - 1];
    const c = code[i];
    if (c === '(' || c === '[') ++at.depth;
    if (c === ')' || c === ']') --at.depth;
    if (c === ';' && at.depth === 0) {
      if (at.kind === 'code') found.push([at.start, i + 1]);
      at.start = i + 1;
    } else if (c === '{') {
      const head = code.slice(at.start, i);
      const kind = opens(head, at.kind === 'code');
      // The head of a block is a statement of its own: its condition may be negated.
      if (kind === 'code' && at.kind === 'code' && at.depth === 0) found.push([at.start, i]);
      stack.push({ kind, start: i + 1, depth: 0, isNested: at.depth > 0 || /=\s*\[/.test(head) });
    } else if (c === '}' && stack.length > 1) {
      const block = stack.pop();
      const outer = stack[stack.length - 1];
      if (block.kind !== 'list' && !block.isNested) {
        const isLoop = /^\s*do\s*$/.test(code.slice(outer.start, block.start - 1));
        outer.start = isLoop ? i : i + 1; // of a do loop, `while (...);` is still to come
      }
    }
  }
  return found;
}

const declaration =
  /^(?:const|constexpr|auto|static|static_assert|using|typedef|template|struct|class|enum|friend|assert|namespace|\[\[|public|private|protected)\b|^\[\[/;
const typeAndName =
  /^(?!return\b|delete\b|else\b)(?:unsigned |typename )?[A-Za-z_][\w:]*(?:<[^;=]*>)?(?:::\w+)?\s*[&*]?\s+[&*]?[A-Za-z_]\w*\s*(?:=|;|\{|\(|\[)/;

function mutate(code, [from, to], mutants) {
  let start = from;
  const rest = () => code.slice(start, to);
  const skip = (pattern) => {
    const length = pattern.exec(rest())?.[0].length ?? 0;
    start += length;
    return length > 0;
  };
  while (skip(/^[\s}]+/) || skip(/^else\b/) || skip(/^(?:case\b[^?;]*?[^:]:(?!:)|default\s*:)/));
  if (start >= to) return;
  const add = (kind, first, last, replacement) =>
    mutants.push({ kind, at: start, start: first, end: last, replacement });

  const control = /^(if|for|while|switch)\b\s*(constexpr)?\s*\(/.exec(rest());
  if (control) {
    const open = start + control[0].length - 1;
    const close = closing(code, open);
    if (control[1] !== 'switch' && !control[2]) {
      const [first, last] = condition(code, open + 1, close, control[1]);
      if (first < last) add('negate', first, last, `!(${code.slice(first, last).trim()})`);
    }
    const body = code.slice(close + 1, to);
    if (control[1] === 'if' && !control[2]) {
      const [first, last] = condition(code, open + 1, close, 'if');
      if (/^\s*return\b[\s\S]*;$/.test(body)) add('delete-refusal', start, to, ';');
      const opensReturn = /^\s*\{\s*return\b/.test(code.slice(close + 1));
      if (opensReturn && first < last) add('delete-refusal', first, last, 'false');
    }
    if (body.trim() !== '') mutate(code, [close + 1, to], mutants);
    return;
  }
  const text = rest();
  if (declaration.test(text) || typeAndName.test(text)) {
    for (const at of questions(code, start, to)) add('negate', at, at, ' == false ');
    return;
  }
  if (/^return\b/.test(text)) {
    const first = start + 'return'.length;
    for (const at of questions(code, start, to)) add('negate', at, at, ' == false ');
    if (comparesOrJoins(code.slice(first, to - 1))) {
      add('negate-return', first, to - 1, ` !(${code.slice(first, to - 1).trim()})`);
    }
    return;
  }
  if (text === ';' || !text.endsWith(';')) return;
  for (const at of questions(code, start, to)) add('negate', at, at, ' == false ');
  add('delete', start, to, ';');
}

function closing(code, open) {
  let depth = 0;
  for (let i = open; i < code.length; ++i) {
    if ('([{'.includes(code[i])) ++depth;
    if (')]}'.includes(code[i]) && --depth === 0) return i;
  }
  return code.length;
}

/** Calls `each` with every character of a range that is in no brackets. */
function forTopLevel(code, from, to, each) {
  let depth = 0;
  for (let i = from; i < to; ++i) {
    if ('([{'.includes(code[i])) ++depth;
    if (')]}'.includes(code[i])) --depth;
    if (depth === 0) each(i);
  }
}

/** The range of the condition in the brackets of an `if` or a loop; empty if there is none. */
function condition(code, from, to, keyword) {
  const parts = [from];
  forTopLevel(code, from, to, (i) => code[i] === ';' && parts.push(i + 1));
  if (keyword === 'for') return parts.length === 3 ? [parts[1], parts[2] - 1] : [0, 0];
  const first = parts[parts.length - 1];
  const isDeclaration = /^\s*(?:const\s+)?[\w:<>*&\s]+\s[\w]+\s*=[^=]/.test(code.slice(first, to));
  return isDeclaration ? [0, 0] : [first, to];
}

/** Where the `?` of a `?:` stand that are in no brackets. */
function questions(code, from, to) {
  const found = [];
  forTopLevel(code, from, to, (i) => code[i] === '?' && found.push(i));
  return found;
}

function comparesOrJoins(expression) {
  let isCondition = /^\s*!/.test(expression);
  forTopLevel(expression, 0, expression.length, (i) => {
    isCondition ||= /^(?:&&|\|\||==|!=|[<>]=? )/.test(expression.slice(i, i + 3));
  });
  return isCondition && questions(expression, 0, expression.length).length === 0;
}
