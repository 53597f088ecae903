/* fog_model.h of the generic image: what it has room for. Its model is loaded into flash (SPEC.md, "Model slots"), by
 * `fogcomp load` or with a programmer, and says itself what of this it uses. C++ only. */
#ifndef FOG_MODEL_H
#define FOG_MODEL_H

#define FOG_MODEL_IN_SLOTS 1
#define FOG_MODEL_LAYOUT fog::kModelLayout
#define FOG_MODEL_EFFECTS fog::kAllEffects
#define FOG_MODEL_EXPRESSIONS fog::kAllExpressions
#define FOG_MODEL_NETWORK_INPUTS fog::kAllNetworkInputs
#define FOG_MODEL_TAPS fog::kGenericTaps
#define FOG_MODEL_LEVELS fog::kGenericLevels
#define FOG_MODEL_OUTPUT 2 /* frames: 0 KVH, 1 compact, 2 both */
#define FOG_MODEL_OUTPUT_OPTIONS fog::kAllOutputOptions
#define FOG_MODEL_SENSOR_LINE 0 /* the table's */
#define FOG_MODEL_OUTPUT_LINE 0

#endif
