// The interface's colours as variables of a style sheet: assets/theme.json, dark unless the reader prefers light.
import {readFileSync} from 'node:fs';

const {dark, light} = JSON.parse(readFileSync(new URL('../assets/theme.json', import.meta.url), 'utf8')).interface;
const variables = colours => Object.entries(colours).map(([name, colour]) => `--${name.replaceAll('_', '-')}:${colour};`).join('');

export const themeStyle = `:root{${variables(dark)}}@media (prefers-color-scheme:light){:root{${variables(light)}}}`;
