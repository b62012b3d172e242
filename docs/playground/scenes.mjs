// The scenes to choose from. Their texts are files of the repository, which the build puts into scene_texts.mjs.
import {texts} from './scene_texts.mjs';

// most: the number of events to run.
export const scenes = [
  {title: 'grazing pair', text: texts.grazing_pair, most: 1},
  {title: 'pool table', text: texts.pool_break, most: 400},
  {title: 'corner pocket', text: texts.corner_pocket, most: 300},
  {title: 'Galperin’s blocks', text: texts.galperin, most: 1000},
  {title: 'Sinai’s billiard', text: texts.sinai, most: 200},
];
