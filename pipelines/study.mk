# The study of one scene: random fields, one run of mpmrun per realization, statistics, zones, pictures.
#
# Beside a scene, a Makefile of three lines:
#     # what the study is about
#     SCENE := scene.toml
#     include ../study.mk
#
#   make -j8            everything, into out/; stop it at any time, the same command goes on where it stopped
#   make -j8 N=2000     another number of realizations; after N=1000 only the new thousand is run
#   make rows           the runs alone; make tables: and what follows from them but pictures
#   make Q=             show each command
#   make -j8 converge   as many realizations as the targets want: TARGETS="mean=0.2 runout_m:quantile_0.9=0.5" (rules of mcstats
#                       --stop), looking after LEAST=100 runs and then after each fifth more, at most CAP=10000; of runs drawn in
#                       blocks, LEAST and CAP are best whole numbers of blocks
#   make report         everything, and OUT/report.html: one file with pictures, tables, scene, warnings and commands, for any browser; it
#                       wants pandoc. Under "what was calibrated" stand the scene's comments that say so
#   make clean          remove out/
#
# What comes of it, in OUT:
#   fields/K.h5 points/K.h5   realizations K to K+49: rfgen's and rfmap's files. Batches are always full, so that a greater N
#                             changes none of them
#   in_situ.h5                the state before any soil yields, where all realizations start (mpmrun --make-in-situ): rows are the same as
#                             without it
#   rows/K.tsv                realization K: mpmrun's row; 0 is the deterministic run
#   rows.tsv                  all rows, and from them statistics.tsv, classes.tsv, curve.tsv, and trace.tsv, histogram.tsv, densities.tsv
#   structures.tsv            the classes of the structures listed in STRUCTURES
#   shown/                    realization SHOWN in full: material points, ground surface, state for ParaView
#   *.png *.svg, summary.txt
# A scene without [field] is one deterministic run, realization 0: shown/ and its picture.
#
# What is there is kept only as long as the scene's text, its measurements and the bytes of the tools that made it are the same: rows of two scenes
# or of two versions never stand in one table.
include $(dir $(lastword $(MAKEFILE_LIST)))rules.mk

SCENE ?= scene.toml
STRUCTURES ?= $(wildcard structures.tsv)
Q ?= @

# ---- what the scene says ------------------------------------------------------------------------------------------------

# A value of the parsed scene, or the last line of what is wrong with it.
scene_value = $(shell python3 -c 'import sys, tomllib; scene = tomllib.load(open(sys.argv[1], "rb")); print($1)' $(SCENE) 2>&1 | tail -n 1)
has_field := $(call scene_value,any("field" in table for table in [scene, *scene.get("soil", [])]))
$(if $(filter True False,$(has_field)),,$(error $(SCENE): $(has_field)))
is_random := $(filter True,$(has_field))
# Tables of measurements that its fields honour, named from the scene's folder.
measurements := $(if $(is_random),$(addprefix $(dir $(SCENE)),$(call scene_value,\
  " ".join(field["measurements"] for table in [scene, *scene.get("soil", [])] for field in table.get("field", {}).values() if "measurements" in field))))
ifndef N
N := $(if $(is_random),$(call scene_value,scene["study"]["realizations"]),0)
endif

# ---- file names ---------------------------------------------------------------------------------------------------------

batch_size := 50

ifdef is_random
ifeq ($(shell [[ "$(N)" =~ ^([2-9]|[1-9][0-9]{1,5})$$ ]] && echo good),)
$(error N, the number of realizations, is '$(N)': give a whole number from 2 to 999999, as N=100 or as [study] realizations)
endif
SHOWN ?= 1
# "first realization of the batch/realization" for each: 000001/000001 ... 000001/000050 000051/000051 ...
numbered := $(shell awk -v n=$(N) -v size=$(batch_size) 'BEGIN { for (k = 1; k <= n; ++k) printf "%06d/%06d ", k - (k - 1) % size, k }')
else
SHOWN := 0
numbered :=
endif

points_of = $(OUT)/points/$(patsubst %/,%,$(dir $1)).h5
row_of = $(OUT)/rows/$(notdir $1).tsv
batches := $(sort $(foreach pair,$(numbered),$(call points_of,$(pair))))
random_rows := $(foreach pair,$(numbered),$(call row_of,$(pair)))
rows := $(if $(is_random),$(OUT)/rows/000000.tsv $(random_rows))
shown := $(addprefix $(OUT)/shown/,row.tsv points.tsv surface.tsv state.hdf)
shown_points := $(if $(is_random),$(shell printf '$(OUT)/points/%06d.h5' $$(($(SHOWN) - ($(SHOWN) - 1) % $(batch_size)))))
series := trace.tsv histogram.tsv densities.tsv
tables := $(if $(is_random),$(addprefix $(OUT)/,statistics.tsv $(series) classes.tsv curve.tsv $(if $(STRUCTURES),structures.tsv)))
pictures := $(OUT)/slope.png $(if $(is_random),$(addprefix $(OUT)/,exceedance.png zones.png trace.png distribution.png))

TARGETS ?= mean=0.2
LEAST ?= 100
CAP ?= 10000

.PHONY: all rows tables pictures converge report clean FORCE
all: $(OUT)/summary.txt
	@cat $<
rows: $(or $(rows),$(OUT)/shown/row.tsv)
	$(if $(is_random),@$(progress) end)
tables: $(tables)
pictures: $(pictures)
report: $(OUT)/report.html
	@echo "Report: $(shown_out)/report.html"
converge:
	+$(Q)$(here)converge '$(MAKE)' $(OUT) $(LEAST) $(CAP) $(TARGETS)
clean:
	rm -rf $(OUT)

# ---- what results depend on beside files --------------------------------------------------------------------------------

# Each is rewritten only where it differs, so that a mere touch of the scene or an equal build costs nothing.
$(OUT)/scene.toml: FORCE | $(OUT)
	@cmp -s $(SCENE) $@ || cp $(SCENE) $@

run_tools := rfgen rfmap mpmrun
$(OUT)/tools.sum: FORCE | $(OUT)
	$(foreach tool,$(run_tools),$(if $(shell PATH='$(PATH)' command -v $(tool)),,\
	  $(error $(tool) is neither in $(TOOLS) nor in PATH: run make at the top level first)))
	@sums=$$(cat $$(command -v $(run_tools)) | cksum); [[ -e $@ && $$sums == "$$(<$@)" ]] || echo "$$sums" >$@

$(OUT)/measurements.sum: FORCE | $(OUT)
	@sums=$$(cat $(measurements) </dev/null | cksum); [[ -e $@ && $$sums == "$$(<$@)" ]] || echo "$$sums" >$@

# A smaller N makes no new row, but other tables.
$(OUT)/realizations: FORCE | $(OUT)
	@cmp -s <(echo $(N)) $@ || echo $(N) >$@

FORCE:

$(OUT) $(OUT)/fields $(OUT)/points $(OUT)/rows $(OUT)/shown:
	@mkdir -p $@

# ---- fields, points, rows -----------------------------------------------------------------------------------------------

number = $$((10\#$*))

made_by := $(OUT)/scene.toml $(OUT)/tools.sum

$(OUT)/fields/%.h5: $(made_by) $(OUT)/measurements.sum | $(OUT)/fields
	$(Q)rfgen $(SCENE) --first $(number) -n $(batch_size) --quiet -o $@

$(OUT)/points/%.h5: $(OUT)/fields/%.h5 | $(OUT)/points
	$(Q)rfmap $(SCENE) $< --quiet -o $@

$(OUT)/in_situ.h5: $(made_by)
	$(Q)mpmrun $(SCENE) --make-in-situ --quiet -o $@

$(foreach pair,$(numbered),$(eval $(call row_of,$(pair)): $(call points_of,$(pair))))
$(random_rows): $(OUT)/rows/%.tsv: $(made_by) | $(OUT)/in_situ.h5 $(OUT)/rows
	$(Q)mpmrun $(SCENE) --points $(filter %.h5,$^) --sample $(number) --in-situ $(OUT)/in_situ.h5 --quiet -o $@
	@$(progress)

started := $(shell date +%s)
progress = $(here)progress $(OUT) $(N) $(started)

$(OUT)/rows/000000.tsv: $(made_by) | $(OUT)/rows
	$(Q)mpmrun $(SCENE) --quiet -o $@

# Thousands of names do not fit on a command line. Of equal provenance and header lines, the first is kept.
$(OUT)/rows.tsv: $(rows) $(OUT)/realizations
	$(if $(is_random),@$(progress) end)
	@$(file >$@.list,$(rows))
	$(Q)xargs -a $@.list cat | awk '!/^(#|realization)/ || !seen[$$0]++' >$@
	@rm $@.list

# ---- one realization in full --------------------------------------------------------------------------------------------

$(shown) &: $(made_by) $(shown_points) | $(OUT)/shown
	$(Q)mpmrun $(SCENE) $(if $(is_random),--points $(shown_points) --sample $(SHOWN) --quiet) -o $(OUT)/shown/row.tsv \
	  --table $(OUT)/shown/points.tsv --profile $(OUT)/shown/surface.tsv --state $(OUT)/shown/state.hdf

# ---- statistics and zones -----------------------------------------------------------------------------------------------

$(OUT)/statistics.tsv: $(OUT)/rows.tsv $(wildcard $(TOOLS)/mcstats)
	$(Q)mcstats $< -o $@

$(addprefix $(OUT)/,$(series)): $(OUT)/%.tsv: $(OUT)/rows.tsv $(wildcard $(TOOLS)/mcstats)
	$(Q)mcstats $< --$* -o $@

$(OUT)/classes.tsv: $(OUT)/rows.tsv $(wildcard $(TOOLS)/zoning)
	$(Q)zoning $< --classes -o $@

$(OUT)/curve.tsv: $(OUT)/rows.tsv $(wildcard $(TOOLS)/zoning)
	$(Q)zoning $< --curve -o $@

$(OUT)/structures.tsv: $(OUT)/rows.tsv $(STRUCTURES) $(wildcard $(TOOLS)/zoning)
	$(Q)zoning $< --structures $(STRUCTURES) -o $@

# ---- pictures: each as PNG and SVG --------------------------------------------------------------------------------------

plot = $(Q)gnuplot -c $(here)plots/$(notdir $(basename $@)).gp $(basename $@)

$(OUT)/slope.png $(OUT)/slope.svg &: $(shown) $(here)plots/slope.gp
	$(plot) $(OUT)/shown

$(OUT)/exceedance.png $(OUT)/exceedance.svg &: $(OUT)/curve.tsv $(here)plots/exceedance.gp
	$(plot) $(OUT)/curve.tsv

$(OUT)/zones.png $(OUT)/zones.svg &: $(OUT)/classes.tsv $(filter %/structures.tsv,$(tables)) $(shown) $(here)plots/zones.gp
	$(plot) $(OUT)/classes.tsv $(OUT)/shown/surface.tsv $(SHOWN) $(filter %/structures.tsv,$^)

$(OUT)/trace.png $(OUT)/trace.svg &: $(OUT)/trace.tsv $(here)plots/trace.gp
	$(plot) $(OUT)/trace.tsv

$(OUT)/distribution.png $(OUT)/distribution.svg &: $(OUT)/histogram.tsv $(OUT)/densities.tsv $(here)plots/distribution.gp
	$(plot) $(OUT)/histogram.tsv $(OUT)/densities.tsv

result_rows := $(if $(is_random),$(OUT)/rows.tsv,$(OUT)/shown/row.tsv)
shown_out := $(patsubst $(abspath $(here)..)/%,%,$(abspath $(OUT)))

$(OUT)/summary.txt: $(result_rows) $(tables) $(pictures) $(here)summary
	@$(here)summary -v title='$(subst ','"'"',$(call scene_value,scene.get("title", "$(SCENE)")))' -v out=$(shown_out) \
	  $(result_rows) $(filter-out $(addprefix $(OUT)/,curve.tsv $(series)),$(tables)) >$@

# ---- report -------------------------------------------------------------------------------------------------------------

# The command that makes this study, as one would type it in this folder.
made_with = make -j8$(if $(is_random), N=$(N)) SCENE=$(SCENE) OUT=$(OUT) report
folder := $(patsubst $(abspath $(here)..)/%,%,$(CURDIR))

$(OUT)/report.html: $(result_rows) $(tables) $(pictures) $(SCENE) $(here)report $(here)report.css
	$(if $(shell command -v pandoc),,$(error 'make report' wants pandoc, which is not installed))
	$(Q)$(here)report $(OUT) $(SCENE) $(folder) '$(made_with)' | \
	  pandoc --from=markdown --to=html5 --self-contained --include-in-header=$(here)report.css --columns=1000 --toc --toc-depth=1 -o $@
