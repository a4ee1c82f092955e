# What every Makefile of the pipelines includes first. A recipe ends at the first command that fails, also within a pipe, and leaves
# no half-made target; targets on the way are kept; make's own rules are off.
#
#   BUILD    the build folder; the programs of its tests/ are in PATH
#   TOOLS    the folder of the tools; they are in PATH, first of all
#   OUT      where results go
#   here     this folder
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:
MAKEFLAGS += --no-builtin-rules --warn-undefined-variables

here := $(dir $(lastword $(MAKEFILE_LIST)))
BUILD ?= $(abspath $(here)../build)
TOOLS ?= $(BUILD)/bin
export PATH := $(TOOLS):$(BUILD)/tests:$(PATH)
OUT ?= out
