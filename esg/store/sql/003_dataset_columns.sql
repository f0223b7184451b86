-- What sampled scenes were drawn from (docs/dataset.md); empty or null for all others.
ALTER TABLE scenes ADD COLUMN rule VARCHAR;
ALTER TABLE scenes ADD COLUMN pair VARCHAR;
ALTER TABLE scenes ADD COLUMN changed VARCHAR;
ALTER TABLE scenes ADD COLUMN parameters VARCHAR;
