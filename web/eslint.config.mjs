// The rules of eslint for all JavaScript; scripts/lint runs it. CASTAWAY_MODULES: the folder in which `npm ci` was run.
import {createRequire} from 'node:module';
import {join} from 'node:path';

const require = createRequire(join(process.env.CASTAWAY_MODULES, 'package.json'));
const js = require('@eslint/js');
const globals = require('globals');

export default [
  js.configs.recommended,
  {
    rules: {
      'array-callback-return': 'error',
      eqeqeq: 'error',
      'no-self-compare': 'error',
      'no-shadow': 'error',
      'no-unreachable-loop': 'error',
      'no-unused-expressions': 'error',
      'no-unused-vars': ['error', {ignoreRestSiblings: true}],  // `{name, ...others}` leaves the name out.
      'no-use-before-define': ['error', {functions: false, variables: false}],
      'no-useless-assignment': 'error',
      'no-var': 'error',
      'prefer-const': 'error',
    },
  },
  {files: ['**/src/**'], languageOptions: {globals: globals.browser}},
  {ignores: ['**/src/**'], languageOptions: {globals: globals.node}},
];
