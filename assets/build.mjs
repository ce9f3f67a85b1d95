// Bundles assets/page into assets/dist, which stands in every page; run by `npm ci && npm run build` in this folder.
// Node is needed here alone: `cargo build` takes what is in dist.
import { build } from 'esbuild';
import { readFileSync, writeFileSync, mkdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(root, 'dist');
mkdirSync(out, { recursive: true });

const libraries = ['three', 'uplot'].map((name) => {
  const folder = join(root, 'node_modules', name);
  const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  return { name, version, license, text: readFileSync(join(folder, 'LICENSE'), 'utf8').trim() };
});
const notices = libraries
  .map(({ name, version, license, text }) => `${name} ${version} (${license})\n\n${text}\n`)
  .join('\n');

const banner = `/*! This page holds the following libraries.\n\n${notices.replaceAll('*/', '* /')}*/`;
const common = { bundle: true, minify: true, charset: 'ascii', legalComments: 'none', logLevel: 'warning' };
await build({
  ...common,
  entryPoints: [join(root, 'page/main.js')],
  format: 'esm',
  target: 'es2021',
  banner: { js: banner },
  outfile: join(out, 'page.js'),
});
await build({ ...common, entryPoints: [join(root, 'page/style/page.css')], target: 'es2021', outfile: join(out, 'page.css') });
writeFileSync(join(out, 'LICENSES.txt'), notices);

// An inline script ends at the first "</script", wherever it stands.
const script = join(out, 'page.js');
const safe = readFileSync(script, 'utf8').replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
writeFileSync(script, safe);
