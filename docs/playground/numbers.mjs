// Reads numbers of scene files to the nearest double, and writes doubles with every bit.

const two = 2n;

// The double nearest to p/q, ties to even; q > 0.
function nearest(p, q) {
  if (p === 0n) return 0;
  const sign = p < 0n ? -1 : 1;
  let above = p < 0n ? -p : p;
  let below = q;
  const length = n => n.toString(2).length;
  let shift = 66 - (length(above) - length(below)); // a quotient of at least 65 bits
  shift = Math.min(shift, 1074 + 2); // below the least double only a sticky bit matters
  if (shift >= 0) above <<= BigInt(shift); else below <<= BigInt(-shift);
  let quotient = above / below;
  if (quotient * below !== above) quotient |= 1n; // sticky
  // Number() rounds to nearest; scaling by a power of two is exact unless the result is subnormal.
  const value = Number(quotient);
  return sign * (shift > 1000 ? value * 2 ** -1000 * 2 ** (1000 - shift) : value * 2 ** -shift);
}

// A JSON number, or a string: a decimal, a hexadecimal float, a fraction of two integers or "inf".
export function readNumber(value) {
  if (typeof value === 'number') return value;
  if (typeof value !== 'string') throw new Error('a number is expected');
  const text = value.trim();
  if (text === 'inf') return Infinity;
  let parts = /^([+-]?\d+)\/(\d+)$/.exec(text);
  if (parts) {
    if (BigInt(parts[2]) === 0n) throw new Error(`${text}: division by zero`);
    return nearest(BigInt(parts[1]), BigInt(parts[2]));
  }
  parts = /^([+-]?)0x([0-9a-f]+)(?:\.([0-9a-f]*))?p([+-]?\d+)$/i.exec(text);
  if (parts) {
    const fraction = parts[3] ?? '';
    const digits = BigInt('0x' + parts[2] + fraction) * (parts[1] === '-' ? -1n : 1n);
    const exponent = Number(parts[4]) - 4 * fraction.length;
    if (Math.abs(exponent) > 4000) throw new Error(`${text}: the exponent is too large`);
    return exponent >= 0 ? nearest(digits * two ** BigInt(exponent), 1n) : nearest(digits, two ** BigInt(-exponent));
  }
  if (/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text)) return Number(text);
  throw new Error(`“${text}” is no number`);
}

// 0x1.8p+3, for a double, or for a float given as a double: 13 or 6 hexadecimal digits.
export function hexadecimal(x, digits = 13) {
  if (!Number.isFinite(x) || x === 0) return String(x);
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  const bits = view.getBigUint64(0);
  const exponent = Number((bits >> 52n) & 0x7ffn);
  const significand = (bits & 0xfffffffffffffn).toString(16).padStart(13, '0').slice(0, digits);
  const power = exponent === 0 ? -1022 : exponent - 1023;
  return `${x < 0 ? '-' : ''}0x${exponent === 0 ? 0 : 1}.${significand}p${power < 0 ? '' : '+'}${power}`;
}

// The number of doubles from x to y; NaN if one of the two is a NaN.
export function ulpsBetween(x, y) {
  const view = new DataView(new ArrayBuffer(8));
  const index = z => {
    view.setFloat64(0, z);
    const bits = view.getBigInt64(0);
    return bits < 0n ? -(bits & 0x7fffffffffffffffn) : bits;
  };
  return Number.isFinite(x) && Number.isFinite(y) ? Number(index(y) - index(x)) : NaN;
}
