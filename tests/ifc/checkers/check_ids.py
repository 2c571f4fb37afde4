# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a file against an Information Delivery Specification, by ifctester: check_ids.py SPECIFICATION.ids FILE.ifc

check_ids.py SPECIFICATION.ids FILE.ifc --break: takes one promise after the other out of the file, in memory, and each
must be missed by the one specification that asks for it.
"""
import sys

import ifcopenshell
import ifcopenshell.util.element as element_of
from ifctester import ids


def failures(specification, model):
    """{specification name: what is wrong}"""
    specification.validate(model, should_filter_version=True)
    found = {}
    for one in specification.specifications:
        if one.status is False:
            texts = [
                f"{failure['element'].is_a()} {getattr(failure['element'], 'Name', None)}: {failure['reason']}"
                for requirement in one.requirements
                for failure in requirement.failures
            ]
            found[one.name] = texts or ["there is none"]
    return found


def property_of(model, kind, set_name, name):
    """The first such property or quantity that belongs to an element of the kind, and its set."""
    for element in model.by_type(kind):
        for relation in element.IsDefinedBy:
            definition = relation.RelatingPropertyDefinition
            if definition.Name == set_name:
                for item in getattr(definition, "HasProperties", None) or definition.Quantities:
                    if item.Name == name:
                        return item
    raise LookupError(f"no {kind} has {set_name}.{name}")


def rename(kind, set_name, name):
    def apply(model):
        property_of(model, kind, set_name, name).Name = "Another"

    return apply


def say(kind, set_name, name, value):
    def apply(model):
        item = property_of(model, kind, set_name, name)
        item.NominalValue = model.create_entity(item.NominalValue.is_a(), value)

    return apply


def unset(kind, attribute):
    def apply(model):
        setattr(model.by_type(kind)[0], attribute, None)

    return apply


def drop(relation, kind):
    def apply(model):
        for one in model.by_type(relation):
            for value in one.get_info().values():
                for item in value if isinstance(value, tuple) else (value,):
                    if isinstance(item, ifcopenshell.entity_instance) and item.is_a(kind):
                        model.remove(one)
                        return
        raise LookupError(f"no {relation} with {kind}")

    return apply


# What is taken away, and a word of the name of each specification that must fail.
BREAKS = [
    (unset("IfcBuildingStorey", "Elevation"), {"Storeys"}),
    (unset("IfcDoor", "OverallWidth"), {"Doors"}),
    (unset("IfcWindow", "OverallHeight"), {"Windows"}),
    (unset("IfcSpace", "Name"), {"Spaces"}),
    (unset("IfcBuilding", "ElevationOfRefHeight"), {"A building"}),
    (rename("IfcWall", "Qto_WallBaseQuantities", "NetVolume"), {"Walls: type"}),
    (rename("IfcWall", "S2B_Evidence", "ThicknessProvenance"), None),
    (rename("IfcSpace", "Qto_SpaceBaseQuantities", "NetFloorArea"), {"Spaces"}),
    (rename("IfcSlab", "Qto_SlabBaseQuantities", "NetVolume"), {"Slabs"}),
    (rename("IfcColumn", "Qto_ColumnBaseQuantities", "CrossSectionArea"), {"Columns"}),
    (rename("IfcColumn", "S2B_Evidence", "SectionProvenance"), {"Columns"}),
    (say("IfcWall", "S2B_Evidence", "CoverageLeft", 1.5), None),
    (say("IfcDoor", "S2B_Evidence", "LeafState", "Ajar"), {"Doors"}),
    (rename("IfcProject", "S2B_Evidence", "SoftwareVersion"), None),
    (drop("IfcRelAssociatesMaterial", "IfcWall"), None),
    (drop("IfcRelContainedInSpatialStructure", "IfcColumn"), None),
    (drop("IfcRelVoidsElement", "IfcWall"), None),
]


def main():
    specification = ids.open(sys.argv[1], validate=True)
    path = sys.argv[2]
    if sys.argv[3:] != ["--break"]:
        found = failures(specification, ifcopenshell.open(path))
        checked = sum(len(one.applicable_entities) for one in specification.specifications)
        for name, texts in found.items():
            print(name, *texts[:5], sep="\n  ")
        if not found:
            print(f"all {len(specification.specifications)} specifications are kept, {checked} entities")
        return 1 if found or checked == 0 else 0
    wrong = 0
    for number, (apply, expected) in enumerate(BREAKS):
        model = ifcopenshell.open(path)
        apply(model)
        found = failures(specification, model)
        # Property instances are shared by elements of several classes where their content is the same: then (None) any
        # specification may be the one that misses it.
        named = bool(found) and (expected is None or all(any(w in name for w in expected) for name in found))
        if not named:
            wrong += 1
            print(f"break {number}: failed {sorted(found)}, not {expected}")
    print(f"{len(BREAKS) - wrong} of {len(BREAKS)} broken promises are noticed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
